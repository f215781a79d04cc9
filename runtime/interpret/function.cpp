#include "runtime/interpret/function.h"

#include <cmath>
#include <numbers>

#include "ir/diag/interpret.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/angle.h"
#include "runtime/geometry/shapes.h"
#include "runtime/interpret/expression.h"
#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

namespace {

struct FunctionRow {
  Word word;
  std::size_t arguments;
  bool ofEntities;
  std::string_view form;
};
constexpr std::array rows = {
    FunctionRow{Word::SQRTF, 1, false, "SQRTF(x)"},
    FunctionRow{Word::SINF, 1, false, "SINF(degrees)"},
    FunctionRow{Word::COSF, 1, false, "COSF(degrees)"},
    FunctionRow{Word::TANF, 1, false, "TANF(degrees)"},
    FunctionRow{Word::ATANF, 1, false, "ATANF(x)"},
    FunctionRow{Word::ATAN2F, 2, false, "ATAN2F(sine,cosine)"},
    FunctionRow{Word::EXPF, 1, false, "EXPF(x)"},
    FunctionRow{Word::LOGF, 1, false, "LOGF(x)"},
    FunctionRow{Word::LOG10F, 1, false, "LOG10F(x)"},
    FunctionRow{Word::ABSF, 1, false, "ABSF(x)"},
    FunctionRow{Word::DOTF, 2, true, "DOTF(vector,vector) or DOTF(point,point)"},
    FunctionRow{Word::LNTHF, 1, true, "LNTHF(vector) or LNTHF(point)"},
    FunctionRow{Word::ANGLF, 2, true, "ANGLF(circle,point)"},
    FunctionRow{Word::NUMF, 1, true, "NUMF(pattern)"},
    FunctionRow{Word::DISTF, 2, true, "DISTF(line,line), DISTF(plane,plane) or DISTF(point,point)"},
};

const FunctionRow* find(Word word) {
  for (const FunctionRow& row : rows) {
    if (row.word == word) {
      return &row;
    }
  }
  return nullptr;
}

std::optional<double> callOfNumbers(State& state,
                                    const ir::Expr& call,
                                    const FunctionRow& row,
                                    const std::vector<Item>& items) {
  std::vector<double> x;
  for (const Item& item : items) {
    const double* number = item.number();
    if (number == nullptr) {
      state.report(
          diagnose(item.span, diag::FunctionOperand, spell(row.word), describe(item), row.form));
      return std::nullopt;
    }
    x.push_back(*number);
  }
  if (row.word == Word::SQRTF && x[0] < 0.0) {
    state.report(diagnose(call.span, diag::NegativeRoot, x[0], -x[0]));
  }
  Result<double> value = functionOfNumbers(row.word, x);
  if (!value) {
    state.reportFailure(call.span, value.takeFailure());
    return std::nullopt;
  }
  return *value;
}

std::optional<double> callOfEntities(State& state,
                                     const ir::Expr& call,
                                     const FunctionRow& row,
                                     const std::vector<Item>& items) {
  std::vector<EntityPtr> entities;
  for (const Item& item : items) {
    const EntityPtr* entity = item.entity();
    if (entity == nullptr) {
      state.report(
          diagnose(item.span, diag::FunctionOperand, spell(row.word), describe(item), row.form));
      return std::nullopt;
    }
    entities.push_back(*entity);
  }
  Result<double> value = functionOfEntities(row.word, entities);
  if (!value) {
    reportAt(state, call.span, value.takeFailure(), items);
    return std::nullopt;
  }
  return *value;
}

double inDegrees(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

Failure noValue(Word function, std::string_view why) {
  return fail(diag::FunctionValue, spell(function), why);
}

Result<double> finite(Word function, double x, double value) {
  if (std::isfinite(value)) {
    return value;
  }
  return fail(diag::NumberOverflow, fmt::format("{}({})", spell(function), x));
}

Result<double> tangent(double x) {
  const auto [sine, cosine] = geometry::sinCosDegrees(x);
  if (cosine == 0.0) {
    return noValue(Word::TANF, fmt::format("the tangent of {} degrees is infinite", x));
  }
  const bool diagonal = std::abs(std::remainder(x, 90.0)) == 45.0;
  return diagonal ? std::copysign(1.0, sine * cosine) : sine / cosine;
}

Result<double> logarithm(Word function, double x) {
  if (x <= 0.0) {
    return noValue(function, fmt::format("{} is not positive", x));
  }
  return function == Word::LOGF ? std::log(x) : std::log10(x);
}

Result<double> angleOf(double sine, double cosine) {
  if (sine == 0.0 && cosine == 0.0) {
    return noValue(Word::ATAN2F, "both arguments are 0");
  }
  // Adding zero turns -0 into 0, so that the angle of the negative axis is 180 and not -180.
  return inDegrees(std::atan2(sine + 0.0, cosine + 0.0));
}

Vec3 triple(const Entity& entity) {
  return {entity.canon[0], entity.canon[1], entity.canon[2]};
}

bool isTriple(const Entity& e) {
  return e.type == EntityType::point || e.type == EntityType::vector;
}

Failure wrongOperands(Word function, std::string_view what) {
  return fail(diag::FunctionOperand, spell(function), what, find(function)->form);
}

Result<double> dot(const Entity& a, const Entity& b) {
  if (!isTriple(a) || a.type != b.type) {
    return wrongOperands(Word::DOTF, fmt::format("{} and {}", spell(a.type), spell(b.type)));
  }
  return triple(a).dot(triple(b));
}

Result<double> polarAngle(const Entity& circle, const Entity& point) {
  if (circle.type != EntityType::circle || point.type != EntityType::point) {
    return wrongOperands(Word::ANGLF,
                         fmt::format("{} and {}", spell(circle.type), spell(point.type)));
  }
  const double x = point.canon[0] - circle.canon[0];
  const double y = point.canon[1] - circle.canon[1];
  if (std::abs(x) <= tolerance::nullDirection && std::abs(y) <= tolerance::nullDirection) {
    return noValue(Word::ANGLF, "the point is the center of the circle");
  }
  const double angle = inDegrees(std::atan2(y, x));
  return angle < 0.0 ? angle + 360.0 : angle + 0.0;
}

Result<double> distance(const Entity& a, const Entity& b) {
  if (a.type == EntityType::point && b.type == EntityType::point) {
    return (triple(a) - triple(b)).norm();
  }
  if ((a.type != EntityType::line && a.type != EntityType::plane) || a.type != b.type) {
    return wrongOperands(Word::DISTF, fmt::format("{} and {}", spell(a.type), spell(b.type)));
  }
  for (const Entity* plane : {&a, &b}) {  // CANON takes any numbers
    const double length = triple(*plane).norm();
    if (!(length > tolerance::nullDirection)) {
      return noValue(Word::DISTF,
                     fmt::format("the normal of a {} is {} long", spell(plane->type), length));
    }
  }
  const geometry::Plane first = geometry::Plane::of(a.canon);
  const geometry::Plane second = geometry::Plane::of(b.canon);
  const Vec3& n = first.normal;
  const Vec3& m = second.normal;
  const double sense = n.dot(m) < 0.0 ? -1.0 : 1.0;
  const double gap = (n - sense * m).lpNorm<Eigen::Infinity>();
  if (gap > tolerance::parallel) {
    return noValue(Word::DISTF, fmt::format("the normals differ by {}: the {}s are not parallel",
                                            gap, spell(a.type)));
  }
  return std::abs(first.distance - sense * second.distance);
}

}  // namespace

Result<double> functionOfNumbers(Word function, const std::vector<double>& x) {
  switch (function) {
    case Word::SQRTF:
      return std::sqrt(std::abs(x[0]));
    case Word::SINF:
      return geometry::sinCosDegrees(x[0]).sin;
    case Word::COSF:
      return geometry::sinCosDegrees(x[0]).cos;
    case Word::TANF:
      return tangent(x[0]);
    case Word::ATANF:
      return inDegrees(std::atan(x[0]));
    case Word::ATAN2F:
      return angleOf(x[0], x[1]);
    case Word::EXPF:
      return finite(function, x[0], std::exp(x[0]));
    case Word::LOGF:
    case Word::LOG10F:
      return logarithm(function, x[0]);
    default:
      return std::abs(x[0]);  // ABSF
  }
}

Result<double> functionOfEntities(Word function, const std::vector<EntityPtr>& e) {
  switch (function) {
    case Word::DOTF:
      return dot(*e[0], *e[1]);
    case Word::LNTHF:
      if (!isTriple(*e[0])) {
        return wrongOperands(function, spell(e[0]->type));
      }
      return triple(*e[0]).norm();
    case Word::ANGLF:
      return polarAngle(*e[0], *e[1]);
    case Word::NUMF:
      if (e[0]->type != EntityType::pattern) {
        return wrongOperands(function, spell(e[0]->type));
      }
      return static_cast<double>(e[0]->canon.size() / 3);
    default:
      return distance(*e[0], *e[1]);  // DISTF
  }
}

std::optional<double> callFunction(State& state, const ir::Expr& call) {
  const FunctionRow* row = find(call.function);
  if (row == nullptr) {
    state.report(diagnose(call.span, diag::FunctionOperand, spell(call.function), "arguments",
                          "that of a word, not a function"));
    return std::nullopt;
  }
  if (call.arguments.size() != row->arguments) {
    state.report(diagnose(call.span, diag::FunctionCount, spell(call.function),
                          call.arguments.size(), row->form));
    return std::nullopt;
  }
  // The common case, one number, needs no list.
  if (!row->ofEntities && row->arguments == 1) {
    if (const auto* expr = std::get_if<ir::ExprId>(&call.arguments[0].value)) {
      const std::optional<double> x = scalar(state, *expr);
      if (!x) {
        return std::nullopt;
      }
      return callOfNumbers(state, call, *row, {{*x, call.arguments[0].span}});
    }
  }
  const std::optional<std::vector<Item>> items = evaluate(state, call.arguments, Use::definition);
  if (!items) {
    return std::nullopt;
  }
  return row->ofEntities ? callOfEntities(state, call, *row, *items)
                         : callOfNumbers(state, call, *row, *items);
}

}  // namespace arelem::runtime::interpret
