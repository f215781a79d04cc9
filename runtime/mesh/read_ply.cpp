// PLY: a header of elements and their properties, then text or bytes.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "runtime/mesh/builder.h"

namespace arelem::mesh {

namespace {
enum class Coding : std::uint8_t { text, little, big };

struct Kind {
  std::string_view name, otherName;
  std::size_t bytes;
  char sort;  ///< i signed, u unsigned, f floating
};
constexpr std::array kinds = {Kind{"char", "int8", 1, 'i'},     Kind{"uchar", "uint8", 1, 'u'},
                              Kind{"short", "int16", 2, 'i'},   Kind{"ushort", "uint16", 2, 'u'},
                              Kind{"int", "int32", 4, 'i'},     Kind{"uint", "uint32", 4, 'u'},
                              Kind{"float", "float32", 4, 'f'}, Kind{"double", "float64", 8, 'f'}};

const Kind* kindOf(std::optional<std::string_view> name) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) {
    return name && (*name == kind.name || *name == kind.otherName);
  });
  return found == kinds.end() ? nullptr : &*found;
}

struct Property {
  std::string name;
  const Kind* kind = nullptr;
  const Kind* count = nullptr;  ///< of a list
};
struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

template <class Value>
double as(std::uint64_t bits) {
  Value value;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

double decoded(const Kind& kind, std::uint64_t bits) {
  switch (kind.sort) {
    case 'f':
      return kind.bytes == 4 ? as<float>(bits) : as<double>(bits);
    case 'u':
      return static_cast<double>(bits);
    default:
      return kind.bytes == 1   ? as<std::int8_t>(bits)
             : kind.bytes == 2 ? as<std::int16_t>(bits)
                               : as<std::int32_t>(bits);
  }
}

class Reader {
 public:
  Reader(std::string_view bytes, Builder& builder)
      : bytes_(bytes), lines_(bytes), builder_(builder) {}

  void read() {
    if (!header()) {
      return;
    }
    at_ = lines_.offset();
    for (const Element& element : elements_) {
      for (long long i = 0; i < element.count && builder_.good(); ++i) {
        row(element);
      }
    }
  }

 private:
  bool wrong(std::string what) {
    builder_.wrong(coding_ == Coding::text ? lines_.number() : 0, std::move(what));
    return false;
  }

  bool header() {
    if (!lines_.next() || lines_.word() != "ply") {
      return wrong("the first line of the file is `ply`");
    }
    while (lines_.next()) {
      const std::string_view word = *lines_.word();
      if (word == "end_header") {
        return std::none_of(elements_.begin(), elements_.end(),
                            [](const Element& e) { return e.properties.empty(); }) ||
               wrong("an element has no properties");
      }
      if (word == "comment" || word == "obj_info") {
        continue;
      }
      if (!(word == "format"     ? format()
            : word == "element"  ? element()
            : word == "property" ? property()
                                 : wrong(fmt::format("`{}` is no word of the header", word)))) {
        return false;
      }
    }
    return wrong("the file ends in its header");
  }

  bool format() {
    const auto name = lines_.word();
    coding_ = name == "binary_little_endian" ? Coding::little
              : name == "binary_big_endian"  ? Coding::big
                                             : Coding::text;
    return coding_ != Coding::text || name == "ascii" ||
           wrong("the format is ascii, binary_little_endian or binary_big_endian");
  }

  bool element() {
    const auto name = lines_.word();
    const auto count = lines_.whole();
    if (!name || !count || *count < 0) {
      return wrong("an element has a name and a number");
    }
    elements_.push_back({std::string(*name), *count, {}});
    return true;
  }

  bool property() {
    Property p;
    auto type = lines_.word();
    if (type == "list") {
      p.count = kindOf(lines_.word());
      type = lines_.word();
      if (p.count == nullptr || p.count->sort == 'f') {
        return wrong("the length of a list is a whole number");
      }
    }
    p.kind = kindOf(type);
    const auto name = lines_.word();
    if (elements_.empty() || p.kind == nullptr || !name) {
      return wrong("a property has a type and a name, and belongs to an element");
    }
    p.name = *name;
    elements_.back().properties.push_back(std::move(p));
    return true;
  }

  std::optional<double> value(const Kind& kind) {
    if (coding_ == Coding::text) {
      return lines_.real();
    }
    if (bytes_.size() - at_ < kind.bytes) {
      return std::nullopt;
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < kind.bytes; ++i) {
      const std::size_t place = coding_ == Coding::little ? i : kind.bytes - 1 - i;
      bits |= std::uint64_t{static_cast<unsigned char>(bytes_[at_ + i])} << (8 * place);
    }
    at_ += kind.bytes;
    return decoded(kind, bits);
  }

  void row(const Element& element) {
    if (coding_ == Coding::text && !lines_.next()) {
      wrong(fmt::format("the file ends among its {} {}", element.count, element.name));
      return;
    }
    std::array<double, 3> place{};
    std::vector<long long> corners;
    for (const Property& p : element.properties) {
      std::optional<double> count = p.count != nullptr ? value(*p.count) : 1.0;
      const bool isFace = p.name == "vertex_indices" || p.name == "vertex_index";
      for (double k = 0.0; count && k < *count; ++k) {
        const auto found = value(*p.kind);
        if (!found) {
          count = std::nullopt;
        } else if (isFace) {
          corners.push_back(std::llround(std::clamp(*found, -1.0, 9e15)));
        } else if (p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z') {
          place[static_cast<std::size_t>(p.name[0] - 'x')] = *found;
        }
      }
      if (!count) {
        wrong(fmt::format("the data of a {} ends early", element.name));
        return;
      }
    }
    if (element.name == "vertex") {
      builder_.corner(place[0], place[1], place[2], lines_.number());
    } else if (element.name == "face") {
      builder_.polygon(corners, coding_ == Coding::text ? lines_.number() : 0);
    }
  }

  std::string_view bytes_;
  Lines lines_;
  Builder& builder_;
  Coding coding_ = Coding::text;
  std::vector<Element> elements_;
  std::size_t at_ = 0;
};
}  // namespace

void readPly(std::string_view bytes, Builder& builder) {
  Reader(bytes, builder).read();
}

}  // namespace arelem::mesh
