#include "ir/cl/record.h"

namespace arelem::cl {

namespace {
TypeCode ofWord(Word word) {
  return {row(word).type, row(word).code};
}

struct CodeOf {
  TypeCode operator()(const Post& post) const {
    return post.foreign.empty() ? ofWord(post.word) : TypeCode{2000, 0};
  }
  TypeCode operator()(const Text& text) const { return ofWord(text.word); }
  TypeCode operator()(const Surface& surface) const { return {3000, surface.role}; }
  TypeCode operator()(const Motion& motion) const {
    switch (motion.way) {
      case Motion::Way::counterclockwise:
        return {15000, 5};
      case Motion::Way::clockwise:
        return {15000, 7};
      case Motion::Way::spline:
        return {15000, 8};
      default:
        return {5000, static_cast<int>(motion.kind)};
    }
  }
  TypeCode operator()(const Switch& s) const { return ofWord(s.word); }
  TypeCode operator()(const Values& values) const { return ofWord(values.word); }
  TypeCode operator()(const Multax&) const { return {9000, 2}; }
  TypeCode operator()(const Units&) const { return {9000, 9}; }
  TypeCode operator()(const Diagnostic&) const { return {13000, 3}; }
  TypeCode operator()(const Listing&) const { return {13000, 4}; }
  TypeCode operator()(const Fini&) const { return {14000, 0}; }
  TypeCode operator()(const Card&) const { return {1000, 0}; }
  TypeCode operator()(const Raw& raw) const { return {raw.type, raw.sub}; }
};
}  // namespace

TypeCode typeCode(const Body& body) {
  return std::visit(CodeOf{}, body);
}

}  // namespace arelem::cl
