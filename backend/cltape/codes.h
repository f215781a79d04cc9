#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "ir/cl/record.h"
#include "ir/diag/result.h"

namespace arelem::backend::tape {

/// The numbers of words on CL tapes: those of the vocabulary, which are the old system's, or those
/// with the changes of a code file, since systems number later words differently.
class Codes {
 public:
  /// The vocabulary's.
  Codes() = default;
  /// With the changes of a code file: tables `major` and `minor`, a code for each word (docs/manual/
  /// cl-files.md). Words outside the vocabulary are welcome. A minor word whose code is given away
  /// is written as text; a major word must then get another code.
  [[nodiscard]] static Result<Codes> read(std::string_view toml, std::string_view file);

  /// The code of a minor word, if it has one by which it can be read back; of a text, the code that
  /// the file gives it.
  [[nodiscard]] std::optional<int> minor(Word word) const;
  [[nodiscard]] std::optional<int> minor(std::string_view text) const;
  /// The minor word with this code: a word, or the text of one outside the vocabulary.
  [[nodiscard]] std::optional<cl::Value> minorOf(int code) const;

  /// The subclass of a 2000 record: that of its word, or 0 for a word outside the vocabulary.
  [[nodiscard]] int major(Word word) const;
  [[nodiscard]] int major(std::string_view foreign) const;
  /// The word with this subclass, as a post without parameters.
  [[nodiscard]] std::optional<cl::Post> majorOf(int code) const;

 private:
  struct Table {
    std::map<std::string, int, std::less<>> codes;
    std::map<int, std::string> words;
    [[nodiscard]] std::optional<int> find(std::string_view word) const;
    [[nodiscard]] const std::string* find(int code) const;
  };
  Table minors_, majors_;
};

}  // namespace arelem::backend::tape
