#include "runtime/define/arguments.h"

namespace arelem::define {

bool Arguments::isOmitted(std::size_t i) const {
  return std::holds_alternative<Omitted>(parameters_[i]);
}

bool Arguments::isScalar(std::size_t i) const {
  return i < parameters_.size() && std::holds_alternative<double>(parameters_[i]);
}

bool Arguments::isEntity(std::size_t i) const {
  return i < parameters_.size() && std::holds_alternative<EntityPtr>(parameters_[i]);
}

bool Arguments::isText(std::size_t i) const {
  return i < parameters_.size() && std::holds_alternative<std::string>(parameters_[i]);
}

Result<std::string> Arguments::fileText(std::string_view name) const {
  return files::read(context_.files != nullptr ? *context_.files : files::Files{}, name);
}

bool Arguments::is(std::size_t i, EntityType type) const {
  return isEntity(i) && entity(i).type == type;
}

bool Arguments::is(std::size_t i, Word word) const {
  return i < parameters_.size() && std::holds_alternative<Word>(parameters_[i]) &&
         std::get<Word>(parameters_[i]) == word;
}

}  // namespace arelem::define
