#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>

#include "app/command.h"
#include "app/options.h"
#include "app/picture_file.h"
#include "app/view/faults.h"
#include "app/view/raster.h"
#include "app/view/scene_builder.h"
#include "app/view/scene_surfaces.h"
#include <fmt/ranges.h>

#include "backend/svg/writer.h"
#include "runtime/path/chords.h"

namespace arelem::app {

namespace {
enum class Kind : std::uint8_t { svg, png, html };
constexpr std::string_view standardStream = "-";

struct ViewOptions {
  Settings settings;
  std::string input;
  std::vector<std::string> outputs;
  std::string views = "auto";
  std::string format = "svg";
  bool part = false;  ///< without TRACUT
  int width = 1600;
};

std::optional<Kind> kindOf(const std::string& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array names = {".svg", ".png", ".html"};
  const auto found = std::find(names.begin(), names.end(), suffix);
  return found == names.end() ? std::nullopt
                              : std::optional(static_cast<Kind>(found - names.begin()));
}

void addOptions(CLI::App& app, ViewOptions& options) {
  app.add_option("FILE", options.input, "a part program; - is standard input")->required();
  app.add_option("-o,--output", options.outputs,
                 ".svg or .png: a picture; .html: a page for a browser; - is standard output, see "
                 "--to; may be "
                 "repeated")
      ->type_name("FILE")
      ->required()
      ->allow_extra_args(false);
  app.add_option("--to", options.format, "what -o - writes to standard output: svg, png or html")
      ->check(CLI::IsMember({"svg", "png", "html"}))
      ->capture_default_str();
  app.add_flag("--part", options.part, "the path in the system of the part: without TRACUT");
  app.add_option("--view", options.views, "what a picture shows: auto, plan, front, side or all")
      ->check(CLI::IsMember({"auto", "plan", "front", "side", "all"}))
      ->capture_default_str();
  app.add_option("--width", options.width, "pixels of a .png")
      ->check(CLI::Range(100, 20000))
      ->capture_default_str();
  addSourceOptions(app, options.settings);
  addMessageOptions(app, options.settings);
}

backend::PictureViews viewsOf(const std::string& name) {
  using backend::PictureViews;
  return name == "plan"    ? PictureViews::plan
         : name == "front" ? PictureViews::front
         : name == "side"  ? PictureViews::side
         : name == "all"   ? PictureViews::all
                           : PictureViews::automatic;
}

/// "not all of it: errors in lines 3, 7", or "" for a program without errors.
std::string warningOf(const Compilation& job) {
  constexpr std::size_t mostLines = 12;
  std::set<std::uint32_t> lines;
  for (const Diagnostic& d : job.log.all()) {
    if (d.severity() == Severity::error && d.at.buffer == job.main) {
      lines.insert(job.sources.locate(d.at.buffer, d.at.begin).line);
    }
  }
  if (job.log.errors() == 0) {
    return "";
  }
  if (lines.empty()) {
    return "not all of it: the program has errors";
  }
  const bool many = lines.size() > mostLines;
  while (lines.size() > mostLines) {
    lines.erase(std::prev(lines.end()));
  }
  return fmt::format("not all of it: errors in {} {}{}", lines.size() == 1 ? "line" : "lines",
                     fmt::join(lines, ", "), many ? ", ..." : "");
}

bool isTracut(const runtime::Action& action) {
  const auto* record = std::get_if<runtime::Pass>(&action.body);
  const auto* post = record == nullptr ? nullptr : std::get_if<cl::Post>(&record->body);
  return post != nullptr && post->word == Word::TRACUT;
}

/// What a picture tells below its title beside the extents, or "".
std::string remarkOf(const Compilation& job) {
  const auto& actions = job.evaluation.actions;
  return std::any_of(actions.begin(), actions.end(), isTracut)
             ? "moved by TRACUT: --part shows it in the part"
             : "";
}

class Both : public cl::RecordSink {
 public:
  Both(cl::RecordSink& first, cl::RecordSink& second) : first_(first), second_(second) {}
  void accept(const cl::Record& record) override {
    first_.accept(record);
    second_.accept(record);
  }

 private:
  cl::RecordSink& first_;
  cl::RecordSink& second_;
};

/// What has errors is left out of a picture; the rest is shown.
std::string pictureOf(Compilation& job,
                      const ViewOptions& options,
                      const InterruptFlag& interrupted) {
  std::ostringstream out;
  const backend::Context context = backendContext(job);
  backend::Shortcomings shortcomings;  // known when all records have passed
  const auto writer =
      backend::makePictureWriter(out, context, viewsOf(options.views), shortcomings);
  FaultTrace missing(job);
  Both both(*writer, missing);
  static_cast<void>(execute(job, *path::makeChordStage(both, job.log), interrupted));
  shortcomings = {warningOf(job), missing.marks(), remarkOf(job)};
  writer->finish();
  return out.str();
}

/// The kind of an output: of a file by its suffix; standard output has the kind of --to.
Kind kindOf(const std::string& path, const ViewOptions& options) {
  return path == standardStream ? *kindOf("picture." + options.format) : *kindOf(path);
}

void produce(Compilation& job, const ViewOptions& options, const InterruptFlag& interrupted) {
  const auto wants = [&](bool page) {
    return std::any_of(options.outputs.begin(), options.outputs.end(), [&](const auto& path) {
      return (kindOf(path, options) == Kind::html) == page;
    });
  };
  std::string picture;
  std::optional<backend::Scene> scene;
  if (wants(false)) {
    picture = pictureOf(job, options, interrupted);
  }
  if (wants(true) && !interrupted) {
    scene = buildScene(job, interrupted);
    if (const std::string remark = remarkOf(job); !remark.empty()) {
      addNote(*scene, "the path is " + remark);
    }
  }
  job.evaluation.actions = {};  // a page is written beside them no longer: they take much room
  for (const std::string& path : options.outputs) {
    if (interrupted) {
      return;
    }
    const Kind kind = kindOf(path, options);
    putPicture(job.log, path, [&](std::ostream& out) {
      if (kind == Kind::html) {
        backend::writePage(out, *scene);
        return true;
      }
      if (kind == Kind::png) {
        return writePng(out, picture, options.width);
      }
      out << picture;
      return true;
    });
  }
}
}  // namespace

int runView(const Invocation& invocation) {
  CLI::App app(
      "Shows a part program: a picture of geometry and path, or a page that plays the path, with "
      "the source beside it.\nOf a program with errors the good part is shown.",
      "view");
  ViewOptions options;
  addOptions(app, options);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  for (const std::string& path : options.outputs) {
    if (path != standardStream && !kindOf(path)) {
      printUsageError("view", "a view is written as .svg, .png or .html, not as `" + path + "`");
      return static_cast<int>(ExitCode::wrongUse);
    }
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  Compilation job(options.settings);
  if (load(job, options.input, interrupted)) {
    static_cast<void>(evaluate(job, interrupted));
    job.program.blocks = {};  // of no use from here on
    if (options.part) {
      std::erase_if(job.evaluation.actions, isTracut);
    }
    produce(job, options, interrupted);
  }
  job.log.print(job.sources, job.main, options.settings);
  return static_cast<int>(job.log.exitCode());
}

}  // namespace arelem::app
