#include "app/options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>

#include "app/exit_code.h"
#include "app/limit_options.h"
#include "app/messages.h"
#include "app/nearest.h"

namespace arelem::app {

namespace {
template <class Number>
bool readNumber(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

std::pair<std::string, std::string> splitAssignment(const std::string& option,
                                                    const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw CLI::ValidationError(option, "`" + text + "` is not of the form name=value");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void setDefine(std::map<std::string, double>& defines, const std::string& text) {
  auto [name, value] = splitAssignment("--define", text);
  double number = 0.0;
  if (!readNumber(value, number) || !std::isfinite(number)) {
    throw CLI::ValidationError("--define", "`" + value + "` is not a number");
  }
  for (char& c : name) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  if (!defines.emplace(name, number).second) {
    throw CLI::ValidationError("--define", "`" + name + "` is given twice");
  }
}

/// An option that may be repeated and takes one word each time.
CLI::Option* addRepeated(CLI::App& app,
                         const std::string& names,
                         const std::string& help,
                         const std::string& value,
                         const std::function<void(const std::string&)>& take) {
  return app
      .add_option_function<std::vector<std::string>>(
          names,
          [take](const std::vector<std::string>& words) {
            for (const std::string& word : words) {
              take(word);
            }
          },
          help)
      ->type_name(value)
      ->allow_extra_args(false);
}

std::vector<std::string> longOptions(const CLI::App& app) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      known.push_back("--" + name);
    }
  }
  return known;
}

std::string unknownOption(const CLI::App& app, const std::vector<std::string>& remaining) {
  const auto option = std::find_if(remaining.begin(), remaining.end(),
                                   [](const std::string& word) { return word.starts_with('-'); });
  if (option == remaining.end()) {
    return "`" + remaining.front() + "` is one word too many";
  }
  const std::string guess = nearest(option->substr(0, option->find('=')), longOptions(app));
  return "unknown option `" + *option + "`" +
         (guess.empty() ? "" : "; did you mean `" + guess + "`?");
}
}  // namespace

void addMessageOptions(CLI::App& app, Settings& settings) {
  using Formats = std::map<std::string, DiagnosticFormat>;
  using Colors = std::map<std::string, ColorChoice>;
  app.add_option("--diagnostics", settings.format,
                 "how messages are written: human, json (one object a line), gnu")
      ->transform(CLI::CheckedTransformer(Formats{{"human", DiagnosticFormat::human},
                                                  {"json", DiagnosticFormat::json},
                                                  {"gnu", DiagnosticFormat::gnu}})
                      .description("FORMAT"));
  app.add_option("--color", settings.color, "auto, always or never; NO_COLOR is obeyed")
      ->transform(CLI::CheckedTransformer(Colors{{"auto", ColorChoice::automatic},
                                                 {"always", ColorChoice::always},
                                                 {"never", ColorChoice::never}})
                      .description("WHEN"));
  app.add_option("--max-errors", settings.maxErrors, "errors shown for one input (20)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  app.add_flag("-q,--quiet", settings.quiet, "no warnings, no summary");
  app.add_flag("-v,--verbose", settings.verbose, "a summary with times");
}

void addSourceOptions(CLI::App& app, Settings& settings) {
  std::map<std::string, frontend::Dialect> dialects;
  for (std::size_t i = 0; i < frontend::dialectCount; ++i) {
    const auto dialect = static_cast<frontend::Dialect>(i);
    dialects.emplace(spell(dialect), dialect);
  }
  app.add_option("--dialect", settings.dialect, "auto, apt360, apt4, cl or native")
      ->transform(CLI::CheckedTransformer(dialects).description("NAME"));
  addRepeated(app, "-D,--define", "gives a scalar a value before the program starts", "NAME=VALUE",
              [&settings](const std::string& word) { setDefine(settings.defines, word); });
  addRepeated(app, "-I,--include", "a folder where LIBRY and INCLUDE look first", "DIR",
              [&settings](const std::string& word) { settings.libraryPath.push_back(word); });
  app.add_option("--codes", settings.codes,
                 "numbers of words on CL tapes, read or written: a TOML file, looked for here and "
                 "in the library; apt4 is there")
      ->type_name("FILE");
  app.add_option_function<std::string>(
         "--frame", [&settings](const std::string& frame) { settings.partFrame = frame == "part"; },
         "places of CL text: as they are written (file), or in the frame of the part, without "
         "MSYS, "
         "ROTABL, LOCAL_ORIGIN (part)")
      ->check(CLI::IsMember({"file", "part"}))
      ->type_name("NAME");
  addLimitOptions(app, settings.limits);
}

CLI::Validator aboveZero() {
  return {[](std::string& text) {
            double value = 0.0;
            const bool good = CLI::detail::lexical_cast(text, value) && value > 0.0;
            return good ? std::string() : "`" + text + "` is not a number above 0";
          },
          "above 0"};
}

std::optional<int> parse(CLI::App& app, std::vector<std::string> words) {
  const std::string command = app.get_name();
  app.allow_extras();
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  try {
    app.parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return static_cast<int>(ExitCode::ok);
  } catch (const CLI::ArgumentMismatch& error) {
    printUsageError(
        command, std::string(error.what()) + " (an option that takes one value may be given once)");
    return static_cast<int>(ExitCode::wrongUse);
  } catch (const CLI::ParseError& error) {
    printUsageError(command, error.what());
    return static_cast<int>(ExitCode::wrongUse);
  }
  std::vector<std::string> remaining = app.remaining();
  std::erase(remaining, "--");  // the mark itself, behind which all words are inputs
  if (!remaining.empty()) {
    printUsageError(command, unknownOption(app, remaining));
    return static_cast<int>(ExitCode::wrongUse);
  }
  return std::nullopt;
}

}  // namespace arelem::app
