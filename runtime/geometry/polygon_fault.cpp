// What is wrong in a file of polygons that CGAL's readers refuse; they do not say it.
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "runtime/geometry/mesh_file.h"

namespace arelem::geometry {

namespace {
/// Lines of a text as their words, without comments.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// The next line that has words; false at the end.
  bool next() {
    words_.clear();
    while (words_.empty() && !text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      split(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
    }
    return !words_.empty();
  }
  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  [[nodiscard]] std::string at(std::string_view fault) const {
    return fmt::format("line {}: {}", line_, fault);
  }

 private:
  void split(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    line = line.substr(0, line.find('#'));
    for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
         begin = line.find_first_not_of(blanks)) {
      line.remove_prefix(begin);
      const std::size_t end = std::min(line.find_first_of(blanks), line.size());
      words_.push_back(line.substr(0, end));
      line.remove_prefix(end);
    }
  }
  std::string_view text_;
  std::vector<std::string_view> words_;
  std::size_t line_ = 0;
};

/// A word as a message shows it.
std::string shown(std::string_view word) {
  constexpr std::size_t most = 20;
  std::string text;
  for (const char c : word.substr(0, most)) {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text;
}

template <class Number>
std::optional<Number> numberOf(std::string_view word) {
  word.remove_prefix(word.starts_with('+') ? 1 : 0);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value)
                                                                  : std::nullopt;
}

/// What is wrong with the three coordinates behind word `first`; nothing where they are right.
std::optional<std::string> vertexFault(const std::vector<std::string_view>& words,
                                       std::size_t first) {
  if (words.size() < first + 3) {
    return fmt::format("a vertex has {} coordinates; it needs 3", words.size() - first);
  }
  for (std::size_t k = first; k < first + 3; ++k) {
    const std::optional<double> value = numberOf<double>(words[k]);
    if (!value || !std::isfinite(*value)) {
      return fmt::format("`{}` is no finite number", shown(words[k]));
    }
  }
  return std::nullopt;
}

/// The same of a face of `corners` numbers behind word `first`, which count vertices from `lowest`
/// to `highest`; `3/1/2` of OBJ counts as 3.
std::optional<std::string> faceFault(const std::vector<std::string_view>& words,
                                     std::size_t first,
                                     std::size_t corners,
                                     long long lowest,
                                     long long highest) {
  if (corners < 3 || words.size() < first + corners) {
    return fmt::format("a face has {} corners; it needs {}", words.size() - first,
                       std::max<std::size_t>(corners, 3));
  }
  for (std::size_t k = first; k < first + corners; ++k) {
    const std::optional<long long> vertex =
        numberOf<long long>(words[k].substr(0, words[k].find('/')));
    if (!vertex) {
      return fmt::format("`{}` is no vertex", shown(words[k]));
    }
    if (*vertex < lowest || *vertex > highest) {
      return fmt::format("a face names vertex {}; there are {} to {}", *vertex, lowest, highest);
    }
  }
  return std::nullopt;
}

std::string objFault(std::string_view bytes) {
  Lines lines(bytes);
  long long vertices = 0;
  while (lines.next()) {
    const std::vector<std::string_view>& words = lines.words();
    if (words[0] == "v") {
      if (const auto fault = vertexFault(words, 1)) {
        return lines.at(*fault);
      }
      ++vertices;
    }
  }
  lines = Lines(bytes);
  while (lines.next()) {
    const std::vector<std::string_view>& words = lines.words();
    const bool fromTheEnd = words.size() > 1 && words[1].starts_with('-');
    if (words[0] == "f") {
      if (const auto fault = faceFault(words, 1, words.size() - 1, fromTheEnd ? -vertices : 1,
                                       fromTheEnd ? -1 : vertices)) {
        return lines.at(*fault);
      }
    }
  }
  return fmt::format("it has {} lines `v x y z` and no face that is read", vertices);
}

/// `vertices` lines of coordinates, then `faces` lines that begin with the number of their corners.
std::string bodyFault(Lines& lines, long long vertices, long long faces) {
  for (long long i = 0; i < vertices + faces; ++i) {
    const bool vertex = i < vertices;
    if (!lines.next()) {
      return fmt::format("it announces {} vertices and {} faces; it ends behind {} of these lines",
                         vertices, faces, i);
    }
    const std::vector<std::string_view>& words = lines.words();
    const std::optional<long long> corners = vertex ? 3 : numberOf<long long>(words[0]);
    if (!corners || *corners < 0 || *corners > static_cast<long long>(words.size())) {
      return lines.at(
          fmt::format("`{}` is not the number of corners that follow", shown(words[0])));
    }
    if (const auto fault =
            vertex ? vertexFault(words, 0)
                   : faceFault(words, 1, static_cast<std::size_t>(*corners), 0, vertices - 1)) {
      return lines.at(*fault);
    }
  }
  return "its faces are not read";
}

std::string offFault(std::string_view bytes) {
  Lines lines(bytes);
  if (!lines.next() || lines.words()[0].find("OFF") == std::string_view::npos) {
    return "it does not begin with `OFF`";
  }
  if (lines.words().size() < 3 && !lines.next()) {
    return "it ends before the numbers of vertices and faces";
  }
  std::vector<std::string_view> counts = lines.words();
  if (counts[0].find("OFF") != std::string_view::npos) {
    counts.erase(counts.begin());
  }
  const auto vertices = numberOf<long long>(counts[0]);
  const auto faces = counts.size() < 2 ? std::nullopt : numberOf<long long>(counts[1]);
  if (!vertices || !faces || *vertices < 0 || *faces < 0) {
    return lines.at("the numbers of vertices and faces are needed");
  }
  return bodyFault(lines, *vertices, *faces);
}

std::string plyFault(std::string_view bytes) {
  Lines lines(bytes);
  if (!lines.next() || lines.words()[0] != "ply") {
    return "it does not begin with `ply`";
  }
  bool text = false;
  long long vertices = 0, faces = 0;
  while (lines.next() && lines.words()[0] != "end_header") {
    const std::vector<std::string_view>& words = lines.words();
    text = text || (words[0] == "format" && words.size() > 1 && words[1] == "ascii");
    if (words[0] == "element" && words.size() > 2) {
      const auto count = numberOf<long long>(words[2]);
      if (!count || *count < 0) {
        return lines.at(fmt::format("`{}` is no count", shown(words[2])));
      }
      (words[1] == "vertex" ? vertices : faces) = *count;
    }
  }
  if (lines.words().empty()) {
    return "its header has no `end_header`";
  }
  return text ? bodyFault(lines, vertices, faces)
              : fmt::format(
                    "its header announces {} vertices and {} faces; the {} bytes of the "
                    "whole file are not these",
                    vertices, faces, bytes.size());
}
}  // namespace

std::string polygonFault(std::string_view bytes, MeshFormat format) {
  return fmt::format("it is not read as {}: {}", spell(format),
                     format == MeshFormat::obj   ? objFault(bytes)
                     : format == MeshFormat::ply ? plyFault(bytes)
                                                 : offFault(bytes));
}

}  // namespace arelem::geometry
