#include "backend/vplus/expression.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "backend/vplus/name.h"

namespace arelem::vplus {

namespace {
constexpr int deepestNesting = 100;
constexpr double radian = std::numbers::pi / 180.0;

Place product(const Place& a, const Place& b) {
  return {a.shift + a.turn * b.shift, a.turn * b.turn, a.known && b.known};
}
Place unknown() {
  return {Vec3::Zero(), robot::Matrix3::Identity(), false};
}
}  // namespace

void Scope::begin(std::vector<Token> line) {
  line_ = std::move(line);
  at_ = 0;
  depth_ = 0;
  error_.reset();
}

void Scope::forget() {
  declared_.clear();
  unset_.clear();
  reals_.clear();
  locations_.clear();
  labels_.clear();
}

void Scope::wrong(std::string_view wanted) {
  if (!error_) {
    const std::string found =
        atEnd() ? std::string("the end of the line") : "`" + token().text + "`";
    error_ = Error{column(), fmt::format("{} stands where {} is expected", found, wanted)};
    at_ = line_.size() - 1;
  }
}

void Scope::wrongAt(std::size_t column, std::string what) {
  if (!error_) {
    error_ = Error{column, std::move(what)};
    at_ = line_.size() - 1;
  }
}

std::string Scope::word() const {
  return token().kind == Token::Kind::word ? token().text : std::string();
}
bool Scope::isSign(std::string_view text) const {
  return token().kind == Token::Kind::sign && token().text == text;
}
bool Scope::take(std::string_view word) {
  if (token().kind != Token::Kind::word || token().text != word) {
    return false;
  }
  next();
  return true;
}
bool Scope::takeSign(std::string_view text) {
  if (!isSign(text)) {
    return false;
  }
  next();
  return true;
}
void Scope::require(std::string_view word) {
  if (!take(word)) {
    wrong(word);
  }
}
void Scope::sign(std::string_view text) {
  if (!takeSign(text)) {
    wrong(fmt::format("`{}`", text));
  }
}
void Scope::end() {
  if (!error_ && !atEnd()) {
    wrong("the end of the line");
  }
}
void Scope::label() {
  if (token().kind != Token::Kind::number) {
    return;
  }
  constexpr double most = 65535.0;
  const double value = token().number;
  if (value != std::floor(value) || value > most) {
    return wrong("a label from 0 to 65535");
  }
  if (!labels_.insert(static_cast<int>(value)).second) {
    return wrongAt(column(), fmt::format("the label {:g} stands twice", value));
  }
  next();
}
void Scope::anyWord(std::string_view wanted) {
  token().kind == Token::Kind::word ? next() : wrong(wanted);
}

std::string Scope::name(std::string_view wanted) {
  const std::string text = word();
  const std::size_t mark = text.starts_with('#') || text.starts_with('$') ? 1 : 0;
  if (text.empty() || isKeyword(text) || !isName(std::string_view(text).substr(mark))) {
    wrong(wanted);
    return "";
  }
  if (text.size() - mark > nameLength) {
    error_ = Error{column(), fmt::format("the name `{}` has {} characters; {} count", text,
                                         text.size() - mark, nameLength)};
    at_ = line_.size() - 1;
    return "";
  }
  next();
  if (takeSign("[")) {
    list();
    sign("]");
  }
  return text;
}

void Scope::setReal(const std::string& name, std::optional<double> value) {
  if (locations_.count(name) != 0) {
    error_ = Error{1, fmt::format("`{}` is a location and cannot become a number", name)};
    return;
  }
  reals_[name] = value;
}

void Scope::setLocation(const std::string& name, const Place& place) {
  if (reals_.count(name) != 0) {
    error_ = Error{1, fmt::format("`{}` is a number and cannot become a location", name)};
    return;
  }
  locations_[name] = place;
}

std::size_t Scope::list() {
  for (std::size_t count = 1;; ++count) {
    if (!isSign(",") && !isSign("]") && !isSign(")") && !atEnd()) {
      expression();
    }
    if (error_ || !takeSign(",")) {
      return count;
    }
  }
}

void Scope::items() {
  do {
    if (token().kind == Token::Kind::text) {
      next();
    } else if (takeSign("/")) {
      anyWord("a format");
    } else if (locations_.count(word()) != 0) {
      next();
    } else {
      expression();
    }
  } while (!error_ && takeSign(","));
}

std::optional<double> Scope::expression() {
  if (++depth_ > deepestNesting) {
    wrong("an expression that is nested less");
  }
  std::optional<double> left = sum();
  for (const char* compare : {"==", "<>", "<=", ">=", "<", ">"}) {
    if (takeSign(compare)) {
      sum();
      left.reset();
      break;
    }
  }
  --depth_;
  return error_ ? std::nullopt : left;
}

std::optional<double> Scope::sum() {
  std::optional<double> left = productOf();
  while (!error_ && (isSign("+") || isSign("-"))) {
    const double sign = isSign("+") ? 1.0 : -1.0;
    next();
    const std::optional<double> right = productOf();
    left = left && right ? std::optional(*left + sign * *right) : std::nullopt;
  }
  return left;
}

std::optional<double> Scope::productOf() {
  std::optional<double> left = factor();
  while (!error_ && (isSign("*") || isSign("/"))) {
    const bool times = isSign("*");
    next();
    const std::optional<double> right = factor();
    left = left && right && (times || *right != 0.0)
               ? std::optional(times ? *left * *right : *left / *right)
               : std::nullopt;
  }
  return left;
}

std::optional<double> Scope::factor() {
  if (takeSign("-")) {
    if (++depth_ > deepestNesting) {
      wrong("an expression that is nested less");
      return std::nullopt;
    }
    const std::optional<double> value = factor();
    --depth_;
    return value ? std::optional(-*value) : std::nullopt;
  }
  if (takeSign("(")) {
    const std::optional<double> value = expression();
    sign(")");
    return value;
  }
  if (token().kind == Token::Kind::number) {
    const double value = token().number;
    next();
    return value;
  }
  if (take("TRUE") || take("ON")) {
    return -1.0;
  }
  if (take("FALSE") || take("OFF")) {
    return 0.0;
  }
  const std::size_t at = column();
  const std::string used = name("a number, a name or `(`");
  if (error_) {
    return std::nullopt;
  }
  if (locations_.count(used) != 0) {
    error_ = Error{at, fmt::format("`{}` is a location, and a number is expected", used)};
    return std::nullopt;
  }
  const auto found = reals_.find(used);
  if (found == reals_.end()) {
    if (declared_.count(used) == 0) {
      unset_.insert(used);
    }
    reals_[used] = std::nullopt;
    return std::nullopt;
  }
  return found->second;
}

Place Scope::location() {
  Place place = term();
  while (!error_ && takeSign(":")) {
    place = product(place, term());
  }
  return place;
}

Place Scope::term() {
  if (++depth_ > deepestNesting) {
    wrong("a location that is nested less");
    return unknown();
  }
  Place place = unknown();
  if (take("TRANS")) {
    place = transformation();
  } else if (take("RX")) {
    place = rotation(Vec3::UnitX());
  } else if (take("RY")) {
    place = rotation(Vec3::UnitY());
  } else if (take("RZ")) {
    place = rotation(Vec3::UnitZ());
  } else if (take("NULL")) {
    place = Place{};
  } else if (take("SHIFT")) {
    place = shifted();
  } else if (take("INVERSE")) {
    sign("(");
    const Place inner = location();
    sign(")");
    place = {-(inner.turn.transpose() * inner.shift), inner.turn.transpose(), inner.known};
  } else if (take("#PPOINT")) {
    arguments(12);
  } else if (!take("HERE") && !take("DEST")) {
    const std::size_t at = column();
    const std::string used = name("a location");
    const auto found = locations_.find(used);
    if (!error_ && reals_.count(used) != 0) {
      error_ = Error{at, fmt::format("`{}` is a number, and a location is expected", used)};
    } else if (!error_ && found != locations_.end()) {
      place = found->second;
    } else if (!error_) {
      locations_[used] = unknown();
      if (declared_.count(used) == 0) {
        unset_.insert(used);
      }
    }
  }
  --depth_;
  return place;
}

/// TRANS(x, y, z, yaw, pitch, roll); what is left out is 0.
Place Scope::transformation() {
  const std::size_t at = column();
  const std::vector<std::optional<double>> a = arguments(6);
  std::array<double, 6> v{};
  for (std::size_t i = 0; i < a.size() && i < v.size(); ++i) {
    if (!a[i]) {
      return unknown();
    }
    v[i] = *a[i];
  }
  if (!error_ && (v[4] < 0.0 || v[4] > 180.0)) {
    error_ = Error{at, fmt::format("the pitch is {:g}; it goes from 0 to 180", v[4])};
  }
  return {Vec3(v[0], v[1], v[2]), robot::matrixOf({v[3], v[4], v[5]}), true};
}

Place Scope::rotation(const Vec3& axis) {
  const auto a = arguments(1);
  if (a.empty() || !a[0]) {
    return unknown();
  }
  return {Vec3::Zero(), Eigen::AngleAxisd(*a[0] * radian, axis).toRotationMatrix(), true};
}

/// SHIFT(location BY dx, dy, dz): along the axes of the world; what is left out is 0.
Place Scope::shifted() {
  sign("(");
  Place place = location();
  require("BY");
  for (int i = 0; i < 3 && !error_; ++i) {
    if (i > 0 && !takeSign(",")) {
      break;
    }
    const bool leftOut = isSign(",") || isSign(")");
    const std::optional<double> step = leftOut ? std::optional(0.0) : expression();
    place.known = place.known && step.has_value();
    place.shift[i] += step.value_or(0.0);
  }
  sign(")");
  return place;
}

std::vector<std::optional<double>> Scope::arguments(std::size_t most) {
  std::vector<std::optional<double>> values;
  sign("(");
  while (!error_ && !isSign(")")) {
    if (values.size() == most) {
      wrong(fmt::format("`)` behind {} values", most));
      break;
    }
    values.push_back(expression());
    if (!isSign(")")) {
      sign(",");
    }
  }
  sign(")");
  return values;
}

}  // namespace arelem::vplus
