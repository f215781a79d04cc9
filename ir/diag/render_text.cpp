#include "ir/diag/render_text.h"

#include <algorithm>
#include <map>
#include <ostream>

#include "ir/diag/display_text.h"
#include "ir/diag/excerpt.h"

namespace arelem {

namespace {
constexpr std::string_view bold = "\033[1m";
constexpr std::string_view red = "\033[1;31m";
constexpr std::string_view magenta = "\033[1;35m";
constexpr std::string_view cyan = "\033[1;36m";
constexpr std::string_view blue = "\033[34m";
constexpr std::string_view reset = "\033[0m";

struct Style {
  std::string_view word;
  std::string_view color;
};
Style styleOf(Severity severity) {
  switch (severity) {
    case Severity::error:
      return {"error", red};
    case Severity::warning:
      return {"warning", magenta};
    case Severity::note:
      return {"note", cyan};
  }
  return {"error", red};
}

bool known(const Span& span, const SourceMap& sources) {
  return span.buffer.index < sources.size();
}

class TextRenderer {
 public:
  TextRenderer(std::ostream& out, const SourceMap& sources, const TextRendering& rendering)
      : out_(out), sources_(sources), rendering_(rendering) {}

  void render(const Diagnostic& d) {
    headline(d);
    if (!rendering_.excerpt) {
      return;
    }
    excerpts(d);
    calledFrom(d);
    for (const std::string& note : d.notes) {
      out_ << "   " << paint(cyan) << "note: " << paint(reset) << displayText(note) << '\n';
    }
    closing(d);
  }

 private:
  [[nodiscard]] std::string_view paint(std::string_view color) const {
    return rendering_.color ? color : std::string_view{};
  }

  void headline(const Diagnostic& d) {
    const Style style = styleOf(d.severity());
    const std::string place = describePlace(d.at, sources_);
    out_ << paint(bold) << (place.empty() ? "arelem" : place) << ": " << paint(style.color)
         << style.word << '[' << d.kind().code << "]: " << paint(reset) << paint(bold)
         << displayText(d.message) << paint(reset) << '\n';
  }

  using LineNumber = std::uint32_t;

  /// Marks for one span: where it runs over several lines, those of the first and of the last one.
  void addMarks(std::map<LineNumber, std::vector<Mark>>& lines,
                const Span& span,
                bool primary,
                const std::string& text) const {
    const LineNumber first = sources_.locate(span.buffer, span.begin).line;
    const std::uint32_t lastByte = span.length > 0 ? span.end() - 1 : span.begin;
    const LineNumber last = sources_.locate(span.buffer, lastByte).line;
    for (const LineNumber n : {first, last}) {
      const std::string_view line = sources_.line(span.buffer, n);
      const auto start =
          static_cast<std::uint32_t>(line.data() - sources_.text(span.buffer).data());
      const auto blank = std::min(line.find_first_not_of(" \t"), line.size());
      Mark mark;
      mark.primary = primary;
      mark.begin = n == first ? span.begin - start : static_cast<std::uint32_t>(blank);
      mark.end = n == last ? span.end() - start : static_cast<std::uint32_t>(line.size());
      mark.end = std::min(mark.end, static_cast<std::uint32_t>(line.size()));
      mark.end = std::max(mark.begin, mark.end);
      mark.text = n == last ? text : "";
      lines[n].push_back(mark);
      if (first == last) {
        return;
      }
    }
  }

  void print(BufferId buffer, const std::map<LineNumber, std::vector<Mark>>& lines) {
    LineNumber previous = 0;
    for (const auto& [number, marks] : lines) {
      if (previous != 0 && number > previous + 1) {
        out_ << paint(blue) << "  ... |" << paint(reset) << '\n';
      }
      previous = number;
      const Excerpt shown = excerpt(sources_.line(buffer, number), marks, rendering_.width);
      const bool primary =
          std::any_of(marks.begin(), marks.end(), [](const Mark& m) { return m.primary; });
      out_ << paint(blue) << fmt::format("{:5} |", number) << paint(reset)
           << (shown.source.empty() ? "" : " ") << shown.source << '\n';
      for (const std::string& row : shown.underlines) {
        out_ << paint(blue) << "      | " << paint(primary ? red : cyan) << row << paint(reset)
             << '\n';
      }
    }
  }

  void excerpts(const Diagnostic& d) {
    if (!known(d.at, sources_)) {
      return;
    }
    std::map<LineNumber, std::vector<Mark>> lines;
    addMarks(lines, d.at, true, "");
    std::map<BufferId, std::map<LineNumber, std::vector<Mark>>> elsewhere;
    for (const Label& label : d.labels) {
      if (known(label.span, sources_)) {
        const bool here = label.span.buffer == d.at.buffer;
        addMarks(here ? lines : elsewhere[label.span.buffer], label.span, false, label.text);
      }
    }
    print(d.at.buffer, lines);
    for (const auto& [buffer, marked] : elsewhere) {
      out_ << paint(blue) << "  --> " << paint(reset) << displayText(sources_.name(buffer)) << '\n';
      print(buffer, marked);
    }
  }

  void calledFrom(const Diagnostic& d) {
    const std::size_t shown = std::min(d.calledFrom.size(), rendering_.calls);
    for (std::size_t i = 0; i < shown; ++i) {
      out_ << "   " << paint(cyan) << "called from " << paint(reset)
           << describePlace(d.calledFrom[i], sources_) << '\n';
    }
    if (shown < d.calledFrom.size()) {
      out_ << "   " << fmt::format("… {} more calls", d.calledFrom.size() - shown) << '\n';
    }
  }

  void closing(const Diagnostic& d) {
    const std::string old =
        d.kind().legacy.empty() ? "" : fmt::format("[old APT number: {}]", d.kind().legacy);
    if (!d.help.empty()) {
      out_ << "   " << paint(cyan) << "help: " << paint(reset);
      // A help may list forms, one a line.
      std::string_view rest = d.help;
      for (std::size_t end = rest.find('\n'); end != std::string_view::npos;
           end = rest.find('\n')) {
        out_ << displayText(rest.substr(0, end)) << "\n         ";
        rest.remove_prefix(end + 1);
      }
      out_ << displayText(rest);
      out_ << (old.empty() ? "" : "\n   ") << old << '\n';
    } else if (!old.empty()) {
      out_ << "   " << old << '\n';
    }
  }

  std::ostream& out_;
  const SourceMap& sources_;
  const TextRendering& rendering_;
};
}  // namespace

std::string describePlace(const Span& span, const SourceMap& sources) {
  if (!known(span, sources)) {
    return "";
  }
  const LineColumn place = sources.locate(span.buffer, span.begin);
  return fmt::format("{}:{}:{}", displayText(sources.name(span.buffer)), place.line, place.column);
}

void renderText(std::ostream& out,
                const Diagnostic& diagnostic,
                const SourceMap& sources,
                const TextRendering& rendering) {
  TextRenderer(out, sources, rendering).render(diagnostic);
}

}  // namespace arelem
