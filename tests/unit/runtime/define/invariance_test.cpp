// Every form under shifts, scales, quarter turns and mirrors of the plane: what is done to the
// parameters is done to the result. Modifiers turn with the axes, LEFT and RIGHT, CLW and CCLW are
// exchanged by a mirror. The parameters are drawn from the patterns of the forms themselves, so a
// new row is tested without an edit here.
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "ir/define/forms.h"
#include "ir/define/pattern.h"
#include "runtime/geometry/shapes.h"
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

/// x' = s R x + t in space: R turns about z by quarter turns and may mirror x.
struct Motion {
  int quarters = 0;
  bool mirror = false;
  double scale = 1.0;
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 turned(Vec3 v) const {
    if (mirror) {
      v.x() = -v.x();
    }
    for (int i = 0; i < quarters; ++i) {
      v = Vec3(-v.y(), v.x(), v.z());
    }
    return v;
  }
  [[nodiscard]] std::vector<double> matrix() const {
    std::vector<double> m;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        m.push_back(scale * turned(Vec3::Unit(column))(row));
      }
      m.push_back(shift(row));
    }
    return m;
  }
  [[nodiscard]] double angle(double degrees) const {
    return (mirror ? 180.0 - degrees : degrees) + 90.0 * quarters;
  }
};

/// Words that name an axis and a sense.
struct Axial {
  Word word;
  Vec3 sense;
};
const std::vector<Axial>& axials() {
  static const std::vector<Axial> all = {
      {W::XLARGE, {1, 0, 0}},  {W::XSMALL, {-1, 0, 0}}, {W::YLARGE, {0, 1, 0}},
      {W::YSMALL, {0, -1, 0}}, {W::ZLARGE, {0, 0, 1}},  {W::ZSMALL, {0, 0, -1}},
      {W::POSX, {1, 0, 0}},    {W::NEGX, {-1, 0, 0}},   {W::POSY, {0, 1, 0}},
      {W::NEGY, {0, -1, 0}},   {W::POSZ, {0, 0, 1}},    {W::NEGZ, {0, 0, -1}}};
  return all;
}

Word moved(Word word, const Motion& g) {
  const std::map<Word, Word> exchanged = {
      {W::LEFT, W::RIGHT}, {W::RIGHT, W::LEFT}, {W::CLW, W::CCLW}, {W::CCLW, W::CLW}};
  if (g.mirror && exchanged.contains(word)) {
    return exchanged.at(word);
  }
  for (std::size_t i = 0; i < axials().size(); ++i) {
    if (axials()[i].word != word) {
      continue;
    }
    const std::size_t first = i < 6 ? 0 : 6;  // the LARGE words or the POS words
    const Vec3 sense = g.turned(axials()[i].sense);
    for (std::size_t k = first; k < first + 6; ++k) {
      if (axials()[k].sense == sense) {
        return axials()[k].word;
      }
    }
  }
  return word;
}

/// What a scalar of a pattern means, by its name there.
enum class Role { x, y, z, i, j, k, length, angle, count, other };
Role roleOf(std::string_view name) {
  const std::string_view stem = name.substr(0, name.find_first_of("0123456789"));
  const std::map<std::string_view, Role> roles = {
      {"x", Role::x},          {"y", Role::y},         {"z", Role::z},
      {"i", Role::i},          {"j", Role::j},         {"k", Role::k},
      {"r", Role::length},     {"dist", Role::length}, {"major", Role::length},
      {"minor", Role::length}, {"deg", Role::angle},   {"start", Role::angle},
      {"stop", Role::angle},   {"n", Role::count}};
  const auto found = roles.find(stem);
  return found == roles.end() ? Role::other : found->second;
}

/// One parameter as drawn: a word, an entity or a scalar with its role.
struct Drawn {
  Parameter value;
  Role role = Role::other;
};

class Invariance : public testing::Test {
 protected:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool coin() { return std::uniform_int_distribution<int>(0, 1)(random_) == 1; }
  Vec3 place() { return {number(-9, 9), number(-9, 9), number(-9, 9)}; }
  EntityPtr pointAt(const Vec3& p) { return point(p.x(), p.y(), p.z()); }

  /// An entity of a type; null for types that this test does not draw.
  EntityPtr entity(EntityType type) {
    const Vec3 p = place();
    switch (type) {
      case T::point:
        return pointAt(p);
      case T::vector:
        return make(T::vector, {p.x(), p.y(), p.z()});
      case T::line:
        return definedPtr(T::line, {pointAt(p), pointAt(place())});
      case T::plane:
        return definedPtr(T::plane, {p.x(), p.y(), p.z(), number(-9, 9)});
      case T::circle:
        return definedPtr(T::circle, {p.x(), p.y(), number(1, 6)});
      case T::ellipse:
      case T::hyperbola:
        return definedPtr(type,
                          {W::CENTER, pointAt(p), number(1, 6), number(1, 6), number(0, 180)});
      case T::pattern:
        return definedPtr(T::pattern, {W::LINEAR, pointAt(p), pointAt(place()), 4.0});
      default:
        return nullptr;
    }
  }

  Drawn scalar(std::string_view name) {
    const Role role = roleOf(name);
    switch (role) {
      case Role::length:
        return {number(0.5, 4), role};
      case Role::angle:
        return {number(-170, 170), role};
      case Role::count:
        return {3.0, role};
      default:
        return {number(-9, 9), role};
    }
  }

  /// A random way through a pattern; empty where it holds what this test does not draw.
  std::vector<Drawn> draw(const Pattern& pattern) {
    std::vector<Drawn> result;
    int at = pattern.start;
    for (int steps = 0; steps < 60; ++steps) {
      const Pattern::Node& node = pattern.nodes[static_cast<std::size_t>(at)];
      if (node.kind == Pattern::Node::Kind::end) {
        return result;
      }
      if (node.kind == Pattern::Node::Kind::split) {
        at = node.other < 0 || (coin() && node.next >= 0) ? node.next : node.other;
        continue;
      }
      if (node.wanted.sort == Symbol::Sort::word) {
        result.emplace_back().value = node.wanted.word;
      } else if (node.wanted.sort == Symbol::Sort::scalar) {
        result.push_back(scalar(node.wanted.text));
      } else if (node.wanted.sort != Symbol::Sort::entity) {
        return {};
      } else {
        EntityPtr drawn;
        for (int tries = 0; tries < 50 && !drawn; ++tries) {
          const auto code = std::uniform_int_distribution<unsigned>(1, 53)(random_);
          drawn = (node.wanted.types >> code & 1U) != 0 ? entity(static_cast<EntityType>(code))
                                                        : nullptr;
        }
        if (!drawn) {
          return {};
        }
        result.push_back({drawn, Role::other});
      }
      at = node.next;
    }
    return {};
  }

  Motion motion() {
    Motion g;
    g.quarters = std::uniform_int_distribution<int>(0, 3)(random_);
    g.mirror = coin();
    g.scale = number(0.3, 3);
    g.shift = place();
    return g;
  }

  std::mt19937_64 random_{20261122};
};

EntityPtr movedEntity(const Entity& e, const Motion& g) {
  const std::vector<double> m = g.matrix();
  Result<Entity> result = transformed(e, std::span<const double, 12>(m));
  if (!result) {
    ADD_FAILURE() << result.failure().message;
    return nullptr;
  }
  return std::make_shared<const Entity>(*std::move(result));
}

/// Coordinates and components are moved three (or two) at a time, the others one by one.
P movedParameters(const std::vector<Drawn>& given, const Motion& g) {
  P result;
  for (std::size_t n = 0; n < given.size();) {
    const Drawn& d = given[n];
    const auto value = [&](std::size_t at) { return std::get<double>(given[at].value); };
    if (d.role == Role::x || d.role == Role::i) {
      const bool space =
          n + 2 < given.size() && (given[n + 2].role == Role::z || given[n + 2].role == Role::k);
      const Vec3 v = g.scale * g.turned({value(n), value(n + 1), space ? value(n + 2) : 0.0}) +
                     (d.role == Role::x ? g.shift : Vec3::Zero());
      result.insert(result.end(), {v.x(), v.y()});
      if (space) {
        result.emplace_back(v.z());
      }
      n += space ? 3 : 2;
      continue;
    }
    if (const Word* word = std::get_if<Word>(&d.value)) {
      result.emplace_back(moved(*word, g));
    } else if (const EntityPtr* entity = std::get_if<EntityPtr>(&d.value)) {
      result.emplace_back(movedEntity(**entity, g));
    } else if (d.role == Role::length) {
      result.emplace_back(g.scale * value(n));
    } else if (d.role == Role::angle) {
      result.emplace_back(g.angle(value(n)));
    } else {
      result.emplace_back(value(n));
    }
    ++n;
  }
  return result;
}

/// Lines and planes have two normals, conics a free factor.
void expectSame(const Entity& ours, const Entity& wanted, const std::string& what) {
  std::vector<double> a = ours.canon;
  const std::vector<double>& b = wanted.canon;
  ASSERT_EQ(a.size(), b.size()) << what;
  const bool plane = ours.type == T::line || ours.type == T::plane;
  const bool conic = canonicalCount(ours.type) == 10;
  if (plane || conic) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < b.size(); ++i) {
      most = std::abs(b[i]) > std::abs(b[most]) ? i : most;
    }
    const double factor = a[most] == 0.0 ? 1.0 : b[most] / a[most];
    for (double& v : a) {
      v *= plane ? std::copysign(1.0, factor) : factor;
    }
  }
  expectCanon(a, b, 1e-8, what);
}

/// Forms whose words or numbers speak of fixed axes or hold coefficients: shifts, turns and scales
/// do something else to them, which other tests know.
bool isFree(const std::vector<Drawn>& parameters) {
  const std::set<Word> fixed = {W::XAXIS,  W::YAXIS,  W::INTERC, W::XYPLAN, W::YZPLAN,
                                W::ZXPLAN, W::RTHETA, W::THETAR, W::CANON,  W::SLOPE,
                                W::TIMES,  W::UNIT,   W::LENGTH, W::CROSS};
  for (const Drawn& d : parameters) {
    const Word* word = std::get_if<Word>(&d.value);
    if ((word != nullptr && fixed.contains(*word)) ||
        (std::holds_alternative<double>(d.value) && d.role == Role::other)) {
      return false;
    }
  }
  return !parameters.empty();
}

TEST_F(Invariance, OfEveryForm) {
  // Vectors do not move with a shift, and their forms take points for vectors; matrices and
  // tabulated curves have no place of their own. ZSURF and the dropped z of PT_02 stay where they
  // are.
  const std::set<Word> nouns = {W::POINT,  W::LINE, W::PLANE,  W::CIRCLE, W::CYLNDR, W::ELLIPS,
                                W::HYPERB, W::CONE, W::LCONIC, W::SPHERE, W::PATERN, W::TORUS};
  const std::set<std::string_view> other = {"PT_02", "LC_03", "LC_04", "LC_05", "LC_06",
                                            "PA_03", "PA_04", "PA_06", "PA_07", "PA_10",
                                            "CO_01", "PA_11", "PA_12", "LN_07", "LN_11"};
  int forms = 0;
  for (const FormRow& form : formTable()) {
    if (form.anyNoun || !nouns.contains(form.noun) || other.contains(form.idText)) {
      continue;
    }
    const Pattern pattern = compile(form.pattern);
    const EntityType type = *entityType(form.noun);
    int compared = 0;
    for (int i = 0; i < 400 && compared < 60; ++i) {
      const std::vector<Drawn> drawn = draw(pattern);
      if (!isFree(drawn)) {
        continue;
      }
      P given;
      for (const Drawn& d : drawn) {
        given.push_back(d.value);
      }
      const Result<Entity> before = define(type, given, {});
      if (!before || before->form != form.id) {
        continue;
      }
      Motion g = motion();
      if (type == T::circle || type == T::line || type == T::point || type == T::pattern) {
        g.shift.z() = 0.0;  // plane constructions leave out z
      }
      const Result<Entity> behind = define(type, movedParameters(drawn, g), {});
      ASSERT_TRUE(behind.ok()) << form.idText << ": " << behind.failure().message;
      const EntityPtr wanted = movedEntity(*before, g);
      ASSERT_TRUE(wanted);
      expectSame(*behind, *wanted, std::string(form.idText));
      ++compared;
    }
    forms += compared > 0 ? 1 : 0;
  }
  EXPECT_GE(forms, 55);
}

}  // namespace
}  // namespace arelem::define::test
