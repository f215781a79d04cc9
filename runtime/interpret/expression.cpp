#include "runtime/interpret/expression.h"

#include <cmath>

#include "ir/diag/interpret.h"
#include "ir/diag/limits.h"
#include "ir/space/tolerance.h"
#include "runtime/interpret/function.h"

namespace arelem::runtime::interpret {

namespace {

using ir::Expr;
using Kind = ir::Expr::Kind;

/// Exponents beyond this are left to the library: multiplication would gain no accuracy.
constexpr double largestWholeExponent = 1024.0;

double byMultiplication(double base, unsigned exponent) {
  double result = 1.0;
  for (double factor = base; exponent != 0; exponent >>= 1U, factor *= factor) {
    if ((exponent & 1U) != 0U) {
      result *= factor;
    }
  }
  return result;
}

class Calculator {
 public:
  explicit Calculator(State& state) : state_(state) {}

  std::optional<double> value(ir::ExprId id) {
    const Expr& expr = state_.program[id];
    switch (expr.kind) {
      case Kind::number:
        return expr.number;
      case Kind::symbol:
        return symbol(expr);
      default:
        return nested(expr);
    }
  }

 private:
  std::optional<double> nested(const Expr& expr) {
    if (++depth_ > state_.options.limits.nesting) {
      --depth_;
      state_.report(diagnose(expr.span, diag::LimitNesting, state_.options.limits.nesting));
      return std::nullopt;
    }
    const std::optional<double> result = compute(expr);
    --depth_;
    return result;
  }

  std::optional<double> compute(const Expr& expr) {
    switch (expr.kind) {
      case Kind::assign: {
        const std::optional<double> v = value(expr.left);
        return assign(state_, expr.target, v) ? v : std::nullopt;
      }
      case Kind::negate: {
        const std::optional<double> v = value(expr.left);
        return v ? std::optional<double>(0.0 - *v) : std::nullopt;
      }
      case Kind::power:
        return raised(expr);
      case Kind::call:
        return callFunction(state_, expr);
      default:
        return chain(expr);
    }
  }

  std::optional<double> symbol(const Expr& expr) {
    // Plain names are the common case and need no check of a subscript.
    const std::optional<Place> place = state_.place(expr.target);
    if (!place) {
      return std::nullopt;
    }
    if (state_.store.isEntity(*place)) {
      state_.report(diagnose(expr.span, diag::EntityInExpression, state_.spellPlace(*place),
                             spell(state_.program[place->symbol].type)));
      return std::nullopt;
    }
    switch (state_.store.scalarStatus(*place)) {
      case Status::defined:
        return state_.store.scalar(*place);
      case Status::empty:
        state_.reportEmpty(*place, expr.span);
        return std::nullopt;
      default:
        return std::nullopt;
    }
  }

  /// A chain a + b - c ... leans left and may be as long as a statement: it is walked, not recursed
  /// into.
  std::optional<double> chain(const Expr& top) {
    const std::size_t bottom = chain_.size();
    const Expr* expr = &top;
    while (expr->kind == Kind::add || expr->kind == Kind::subtract ||
           expr->kind == Kind::multiply || expr->kind == Kind::divide) {
      chain_.push_back(expr);
      expr = &state_.program[expr->left];
    }
    std::optional<double> result = value(chain_.back()->left);
    while (chain_.size() > bottom) {
      const Expr& operation = *chain_.back();
      chain_.pop_back();
      const std::optional<double> right = value(operation.right);
      result = result && right ? combine(operation, *result, *right) : std::nullopt;
    }
    return result;
  }

  std::optional<double> combine(const Expr& operation, double left, double right) {
    double result = 0.0;
    switch (operation.kind) {
      case Kind::add:
        result = left + right;
        break;
      case Kind::subtract:
        result = left - right;
        break;
      case Kind::multiply:
        result = left * right;
        break;
      default:
        if (right == 0.0) {
          state_.report(diagnose(operation.span, diag::DivisionByZero));
          return std::nullopt;
        }
        result = left / right;
    }
    return finite(operation, result);
  }

  std::optional<double> finite(const Expr& expr, double result) {
    if (std::isfinite(result)) {
      return result;
    }
    state_.report(diagnose(expr.span, diag::NumberOverflow, "the result"));
    return std::nullopt;
  }

  std::optional<double> raised(const Expr& expr) {
    const std::optional<double> base = value(expr.left);
    const std::optional<double> exponent = value(expr.right);
    if (!base || !exponent) {
      return std::nullopt;
    }
    Result<double> result = power(*base, *exponent);
    if (!result) {
      state_.reportFailure(expr.span, result.takeFailure());
      return std::nullopt;
    }
    return *result;
  }

  State& state_;
  std::uint64_t depth_ = 0;
  std::vector<const Expr*> chain_;
};

}  // namespace

Result<double> power(double base, double exponent) {
  const double whole = std::round(exponent);
  const bool isWhole = std::abs(exponent - whole) <= tolerance::wholeExponent;
  if (base == 0.0 && (isWhole ? whole : exponent) < 0.0) {
    return fail(diag::DivisionByZero);
  }
  if (base < 0.0 && !isWhole) {
    return fail(diag::FractionalPower, base, exponent);
  }
  double result = 0.0;
  if (!isWhole) {
    result = std::pow(base, exponent);
  } else if (std::abs(whole) > largestWholeExponent) {
    result = std::pow(base, whole);
  } else {
    result = byMultiplication(base, static_cast<unsigned>(std::abs(whole)));
    result = whole < 0.0 ? 1.0 / result : result;
  }
  if (!std::isfinite(result)) {
    return fail(diag::NumberOverflow, fmt::format("{} ** {}", base, exponent));
  }
  return result;
}

std::optional<double> compared(State& state, ir::ExprId id) {
  const std::optional<double> value = scalar(state, id);
  const Expr& expr = state.program[id];
  if (!value || *value == 0.0 || (expr.kind != Kind::subtract && expr.kind != Kind::add)) {
    return value;
  }
  // Large against what was subtracted: no need to look at the operand again.
  if (std::abs(*value) > tolerance::coincidence) {
    return value;
  }
  const std::optional<double> right = scalar(state, expr.right);
  const bool rounding = right && std::abs(*value) <= tolerance::decimalStep * std::abs(*right);
  return rounding ? 0.0 : value;
}

std::optional<double> scalar(State& state, ir::ExprId expr) {
  return Calculator(state).value(expr);
}

bool assign(State& state, const ir::Target& target, std::optional<double> value) {
  const std::optional<Place> place = state.place(target);
  if (!place) {
    return false;
  }
  if (state.store.isEntity(*place)) {
    state.report(diagnose(target.span, diag::ArrayClass, state.spellPlace(*place),
                          spell(state.program[place->symbol].type), "a scalar"));
    return false;
  }
  if (!value) {
    state.store.poison(*place);
    return false;
  }
  state.store.setScalar(*place, *value, target.span);
  if (state.tracing) {
    state.trace(fmt::format("{} = {}", state.spellPlace(*place), *value));
  }
  return true;
}

}  // namespace arelem::runtime::interpret
