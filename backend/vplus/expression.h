#pragma once
#include <map>
#include <optional>
#include <set>

#include "backend/robot/pose.h"
#include "backend/vplus/lexer.h"

namespace arelem::vplus {

/// A transformation, or one whose value only the robot knows.
struct Place {
  Vec3 shift = Vec3::Zero();
  robot::Matrix3 turn = robot::Matrix3::Identity();
  bool known = true;
};

/// The names of a program and the expressions of one of its lines. The first thing that is wrong on
/// the line is kept; nothing is read after it.
class Scope {
 public:
  struct Error {
    std::size_t column = 1;
    std::string what;
  };

  void begin(std::vector<Token> line);
  /// All names: another program begins on this line.
  void forget();
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  void wrong(std::string_view wanted);
  void wrongAt(std::size_t column, std::string what);

  // ---- the next token
  [[nodiscard]] bool atEnd() const { return token().kind == Token::Kind::end; }
  [[nodiscard]] std::size_t column() const { return token().column; }
  [[nodiscard]] std::string word() const;  ///< "" when it is no word
  [[nodiscard]] bool isSign(std::string_view text) const;
  void next() { at_ += atEnd() ? 0 : 1; }
  bool take(std::string_view word);
  bool takeSign(std::string_view text);
  void require(std::string_view word);
  void sign(std::string_view text);
  void end();
  /// A number at the head of a line.
  void label();
  void anyWord(std::string_view wanted);

  // ---- names
  /// A name of at most 15 characters that is no keyword; with a subscript, which is passed over.
  std::string name(std::string_view wanted);
  void declare(const std::string& name) { declared_.insert(name); }
  void setReal(const std::string& name, std::optional<double> value);
  void setLocation(const std::string& name, const Place& place);
  /// Names that are read before anything sets them and that no declaration owns.
  [[nodiscard]] const std::set<std::string>& unset() const { return unset_; }

  // ---- values; none where only the robot knows them
  std::optional<double> expression();
  Place location();
  std::size_t list();  ///< how many expressions with commas; some may be absent
  void items();        ///< of TYPE and CALL: texts, expressions, locations' names

 private:
  [[nodiscard]] const Token& token() const { return line_[at_]; }
  std::optional<double> sum();
  std::optional<double> productOf();
  std::optional<double> factor();
  Place term();
  Place transformation();
  Place rotation(const Vec3& axis);
  Place shifted();
  std::vector<std::optional<double>> arguments(std::size_t most);

  std::vector<Token> line_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::optional<Error> error_;
  std::set<std::string> declared_;
  std::set<std::string> unset_;
  std::map<std::string, std::optional<double>> reals_;
  std::map<std::string, Place> locations_;
  std::set<int> labels_;
};

}  // namespace arelem::vplus
