#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "app/command.h"
#include "app/library_file.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/picture_file.h"
#include "app/view/raster.h"

#include "backend/alphabet/chart.h"
#include "runtime/stencil/engrave.h"
#include "runtime/stencil/film.h"
#include "runtime/stencil/stencil.h"

namespace arelem::app {

namespace {
struct AlphabetOptions {
  Settings settings;
  std::string file = "roadway.alphabet";
  std::string output;
  double fan = 63.5;
  double most = 25.4;
  double rate = 120.0;
  double height = 2440.0;
  double speed = 600.0;
  bool plain = false;
  bool pens = false;
  int primitive = 0;  ///< that alone; 0: all symbols
};

backend::Chart chartOf(const stencil::Alphabet& alphabet, bool plain) {
  backend::Chart chart;
  chart.title = std::filesystem::path(alphabet.file).filename().string();
  chart.height = alphabet.height;
  chart.lines = !plain;
  for (const stencil::Symbol& symbol : alphabet.symbols) {
    backend::ChartSymbol& drawn = chart.symbols.emplace_back();
    drawn.name = symbol.name;
    drawn.width = symbol.width;
    // As they are painted: strokes that join are one.
    stencil::Placement placement;
    placement.height = alphabet.height;
    const auto runs = stencil::runsOf(symbol.name, alphabet, placement, {}, Limits{});
    if (!runs) {
      continue;  // a symbol of a name that no text can hold
    }
    for (const stencil::Run& run : *runs) {
      auto& lines = drawn.strokes.emplace_back();
      for (const stencil::Line& line : run.lines) {
        lines.push_back({backend::ChartPoint{line.first.x(), line.first.y()},
                         backend::ChartPoint{line.second.x(), line.second.y()}});
      }
    }
  }
  return chart;
}

/// What ENGRAV cuts of each symbol.
backend::Chart penChartOf(const stencil::Alphabet& alphabet, bool plain) {
  backend::Chart chart;
  chart.title = std::filesystem::path(alphabet.file).filename().string() + ", pen lines";
  chart.height = alphabet.penHeight;
  constexpr double pixels = 144.0;  // of the height
  chart.unit = pixels / alphabet.penHeight;
  chart.lines = !plain;
  stencil::Engraving engraving;
  engraving.placement.height = alphabet.penHeight;
  engraving.chord = 0.001 * alphabet.penHeight;
  for (const stencil::Symbol& symbol : alphabet.symbols) {
    backend::ChartSymbol& drawn = chart.symbols.emplace_back();
    drawn.name = symbol.name;
    drawn.width = alphabet.penWidth;
    engraving.text = symbol.name;
    const auto lines = stencil::penLines(engraving, alphabet, Limits{}, stencil::Vec2::Zero());
    if (!lines) {
      continue;
    }
    for (const stencil::PenLine& line : *lines) {
      auto& points = drawn.pens.emplace_back();
      for (const stencil::Vec2& p : line.points) {
        points.emplace_back(p.x(), p.y());
        drawn.width = std::max(drawn.width, p.x());
      }
    }
  }
  return chart;
}

/// SVG, or PNG where the path ends so.
void writeTo(DiagnosticLog& log, const std::string& path, const backend::Chart& chart) {
  putPicture(log, path, [&](std::ostream& out) {
    if (!path.ends_with(".png")) {
      writeChart(out, chart);
      return true;
    }
    constexpr int width = 1600;  // pixels
    std::ostringstream svg;
    writeChart(svg, chart);
    return writePng(out, svg.str(), width);
  });
}

/// What a symbol comes to by every rule of tilt; none where no text can hold it.
constexpr std::array rules = {stencil::TiltRule::off, stencil::TiltRule::trapezoid,
                              stencil::TiltRule::quadrilateral, stencil::TiltRule::best};
struct Painting {
  stencil::Evenness even;
  double firstShare = 50.0;  ///< percent of the first cell's area that half of its paint falls on
};
std::array<std::optional<Painting>, rules.size()> byRules(const std::string& symbol,
                                                          const stencil::Alphabet& alphabet,
                                                          const AlphabetOptions& options) {
  std::array<std::optional<Painting>, rules.size()> all;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    stencil::Statement statement;
    statement.placement.height = options.height;
    statement.speed = options.speed;
    statement.job.gun.fan = options.fan;
    statement.job.tilt = rules.at(i);
    statement.job.limits.most = options.most;
    statement.job.limits.rate = options.rate;
    statement.text = symbol;
    const Result<stencil::Painted> painted =
        stencil::paint(statement, alphabet, options.settings.limits, stencil::Vec2::Zero());
    if (painted) {
      const auto cells = stencil::cellsOf(painted->tracks, statement.job.gun);
      all.at(i) = {stencil::evennessOf(painted->tracks, statement.job.gun),
                   cells.empty() ? 50.0 : cells.front().share};
    }
  }
  return all;
}

void printHead(const stencil::Alphabet& alphabet, const AlphabetOptions& options) {
  std::cout << fmt::format(
      "{}: grid {:g} by {:g}, {} symbols; fan {:g} degrees, height {:g} mm, {:g} mm/s over a grid "
      "unit, tilt up to {:g}, turning by up to {:g} a second\n",
      alphabet.file, alphabet.width, alphabet.height, alphabet.symbols.size(), options.fan,
      options.height, options.speed, options.most, options.rate);
}

bool areSame(const stencil::Shape& a, const stencil::Shape& b) {
  const auto same = [](const stencil::Line& p, const stencil::Line& q) {
    return p.first == q.first && p.second == q.second;
  };
  return a.isStraight()
             ? std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(), same)
             : &a == &b;
}

/// One primitive alone, not mirrored or moved: each form that strokes of that number have, and the
/// first symbol that has it.
stencil::Alphabet primitivesOf(const stencil::Alphabet& alphabet,
                               int number,
                               std::vector<std::string>& users) {
  stencil::Alphabet alone = alphabet;
  alone.symbols.clear();
  for (const stencil::Symbol& symbol : alphabet.symbols) {
    for (const stencil::Stroke& stroke : symbol.strokes) {
      const bool known =
          std::any_of(alone.symbols.begin(), alone.symbols.end(), [&](const stencil::Symbol& one) {
            return one.strokes[0].cells == stroke.cells &&
                   areSame(*one.strokes[0].shape, *stroke.shape);
          });
      if (stroke.primitive != number || known) {
        continue;
      }
      users.push_back(symbol.name);
      stencil::Symbol& one = alone.symbols.emplace_back();
      one.name = fmt::format("<{}>", users.size());
      one.width = symbol.width;
      stencil::Stroke& made = one.strokes.emplace_back();
      made.primitive = number;
      made.shape = stroke.shape;
      made.cells = stroke.cells;
    }
  }
  return alone;
}

/// Film of every symbol by every rule of tilt.
void printFilms(const stencil::Alphabet& alphabet, const AlphabetOptions& options) {
  printHead(alphabet, options);
  std::cout
      << "film over the mean film, smallest and largest: all of its cells in ten strips each\n";
  std::cout << fmt::format("{:<10}{:>7}{:>8}{:>7}{:>16}{:>16}{:>16}{:>16}\n", "symbol", "strokes",
                           "cells", "area", "OFF", "TRAPZ", "QUADR", "BEST");
  for (const stencil::Symbol& symbol : alphabet.symbols) {
    std::string row;
    stencil::Evenness even;
    for (const auto& one : byRules(symbol.name, alphabet, options)) {
      even = one ? one->even : even;
      row += one ? fmt::format("{:>10.3f} {:<5.3f}", even.film.least, even.film.most)
                 : fmt::format("{:>16}", "-");
    }
    const double unit = options.height / alphabet.height;
    std::cout << fmt::format("{:<10}{:>7}{:>8}{:>7.2f}{}\n", symbol.name, symbol.strokes.size(),
                             even.cells, even.area / (unit * unit), row);
  }
}

/// How the halves of the paint share the cells of one primitive, and its film, by every rule.
bool printPrimitive(const stencil::Alphabet& alphabet, const AlphabetOptions& options) {
  std::vector<std::string> users;
  const stencil::Alphabet alone = primitivesOf(alphabet, options.primitive, users);
  if (users.empty()) {
    return false;
  }
  printHead(alphabet, options);
  std::cout << fmt::format(
      "primitive {} alone: percent of a cell's area that half of its paint falls on, least and "
      "most; film over the mean film\n",
      options.primitive);
  std::cout << fmt::format("{:<10}{:>7}  {:<13}{:>16}{:>16}{:>16}{:>16}\n", "as in", "cells", "",
                           "OFF", "TRAPZ", "QUADR", "BEST");
  for (std::size_t i = 0; i < users.size(); ++i) {
    std::string shares;
    std::string firsts;
    std::string films;
    std::size_t cells = 0;
    for (const auto& one : byRules(alone.symbols[i].name, alone, options)) {
      if (one) {
        const stencil::Evenness& even = one->even;
        cells = std::max(cells, even.cells);
        shares += fmt::format("{:>8.1f} to {:<4.1f}", even.leastShare, even.mostShare);
        firsts += fmt::format("{:>8.1f} and {:<3.1f}", one->firstShare, 100.0 - one->firstShare);
        films += fmt::format("{:>7.3f} to {:<5.3f}", even.film.least, even.film.most);
      }
    }
    std::cout << fmt::format("{:<10}{:>7}  {:<13}{}\n", users[i], cells, "shares, %", shares);
    std::cout << fmt::format("{:<19}{:<13}{}\n", "", "first cell, %", firsts);
    std::cout << fmt::format("{:<19}{:<13}{}\n", "", "film", films);
  }
  return true;
}
}  // namespace

int runAlphabet(const Invocation& invocation) {
  CLI::App app(
      "What the symbols of an alphabet file look like and how evenly they are painted.\n"
      "-o draws them; without it a table of their films is printed.",
      "alphabet");
  AlphabetOptions options;
  app.add_option("FILE", options.file,
                 "an alphabet file, here or in the library; default: roadway.alphabet");
  app.add_option("-o,--output", options.output, "picture of all symbols, .svg or .png")
      ->type_name("FILE");
  app.add_flag("--plain", options.plain, "the picture as on the road, without grid and lines");
  app.add_flag("--pens", options.pens, "the picture of the lines that ENGRAV cuts");
  const auto number = [&](const char* name, double& value, double low, double high,
                          const char* text) {
    app.add_option(name, value, text)
        ->check(CLI::Range(low, high))
        ->type_name("N")
        ->capture_default_str();
  };
  app.add_option("--primitive", options.primitive,
                 "a primitive alone: how the halves of the paint share its cells")
      ->check(CLI::Range(1, 999))
      ->type_name("N");
  number("--fan", options.fan, 5.0, 165.0, "full angle of the gun's fan, degrees");
  number("--tilt", options.most, 0.1, 89.0, "largest tilt, degrees");
  number("--rate", options.rate, 0.1, 1e6, "largest turn of the tilt, degrees a second");
  number("--height", options.height, 1.0, 1e6, "height of the symbols, mm");
  number("--speed", options.speed, 1e-3, 1e6, "speed over a line one grid unit wide, mm/s");
  addMessageOptions(app, options.settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (!options.output.empty() && options.output != "-" && !options.output.ends_with(".svg") &&
      !options.output.ends_with(".png")) {
    printUsageError("alphabet",
                    "a picture is written as .svg or .png, not as `" + options.output + "`");
    return static_cast<int>(ExitCode::wrongUse);
  }
  DiagnosticLog log;
  Result<LibraryFile> file = readLibraryFile(options.file, options.settings);
  Result<stencil::Alphabet> alphabet = file ? stencil::readAlphabet(file->text, file->name)
                                            : Result<stencil::Alphabet>(file.takeFailure());
  if (!alphabet) {
    log.accept(alphabet.takeFailure());
  } else if (!options.output.empty()) {
    writeTo(
        log, options.output,
        options.pens ? penChartOf(*alphabet, options.plain) : chartOf(*alphabet, options.plain));
  } else if (options.primitive == 0) {
    printFilms(*alphabet, options);
  } else if (!printPrimitive(*alphabet, options)) {
    printUsageError("alphabet", fmt::format("no stroke of `{}` is of primitive {}", alphabet->file,
                                            options.primitive));
    return static_cast<int>(ExitCode::wrongUse);
  }
  const SourceMap sources;
  log.print(sources, BufferId{}, options.settings);
  return static_cast<int>(log.exitCode());
}

}  // namespace arelem::app
