#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

#include "certify/base/text.h"
#include "certify/check.h"
#include "certify/file/writer.h"
#include "netgen/base/progress_line.h"
#include "netgen/eigenvalues/eigenvalues.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/input.h"
#include "netgen/program/output.h"

/// The command eigenvalues: intervals with numbers of eigenvalues of the Laplacian, each with its proof.
namespace epsnet::program {
namespace {

using certify::EigenvaluesDocument;
using certify::Interval;

struct EigenvaluesRequest {
  std::string surface;
  std::string up_to;
  std::uint32_t count = 0;
  std::string width;
  std::uint32_t seconds = 0;
  std::string output;
  std::string svg;
  bool fast = false;
  bool json = false;
  unsigned threads = 0;
};

/// Where the eigenvalues of a window are: a single one is both the smallest and the greatest.
Interval enclosure(const EigenvaluesDocument::Window& window) {
  return window.most == 1 && window.least == 1 ? Interval{window.greatest.lower, window.smallest.upper} : window.in;
}

std::string count_text(const EigenvaluesDocument::Window& window) {
  if (window.least == window.most) return "exactly " + std::to_string(window.most);
  if (window.least == 0) return "at most " + std::to_string(window.most);
  return "from " + std::to_string(window.least) + " to " + std::to_string(window.most);
}

/// What is known of the eigenvalues less than 1/4: how many there are at least and at most.
std::pair<std::uint32_t, std::uint32_t> below_quarter(const EigenvaluesDocument& document) {
  std::uint32_t least = 0;
  std::uint32_t most = 0;
  for (const EigenvaluesDocument::Window& window : document.windows) {
    const Interval in = enclosure(window);
    if (in.upper < 0.25) least += window.least;
    if (in.lower < 0.25) most += window.most;
  }
  return {least, most};
}

std::string eigenvalues_text(const EigenvaluesDocument& document) {
  std::ostringstream out;
  double from = 0;
  std::uint64_t index = 1;  // Of the next eigenvalue; 0 where it is not known.
  for (const EigenvaluesDocument::Window& window : document.windows) {
    const Interval in = enclosure(window);
    if (from < in.lower) out << "none in (" << certify::shortest(from) << ", " << certify::shortest(in.lower) << ")\n";
    out << count_text(window) << " in " << to_string(in);
    if (window.least != window.most) {
      index = 0;
    } else if (index != 0) {
      out << ": lambda_" << index;
      if (window.most > 1) out << " to lambda_" << index + window.most - 1;
      index += window.most;
    }
    if (window.least == window.most) {
      if (window.most == 1) {
        out << ", simple";
      } else {
        out << ", the smallest in " << to_string(window.smallest) << ", the greatest in " << to_string(window.greatest);
      }
    }
    out << '\n';
    from = in.upper;
  }
  if (from < document.eigenvalues_up_to)
    out << "none in (" << certify::shortest(from) << ", " << certify::shortest(document.eigenvalues_up_to) << "]\n";
  if (document.eigenvalues_up_to >= 0.25) {
    const auto [least, most] = below_quarter(document);
    out << "eigenvalues in (0, 1/4): ";
    if (least == most) {
      out << (most == 0 ? "none" : std::to_string(most)) << '\n';
    } else {
      out << "from " << least << " to " << most << '\n';
    }
  }
  out << "closed geodesics used: " << document.geodesics.size() << ", of length at most " << document.up_to << '\n';
  if (const auto needed = length_to_count_first(document))
    out << "to count the first ones, take closed geodesics of length up to about " << std::ceil(*needed) << '\n';
  return out.str();
}

Json eigenvalues_json(const EigenvaluesDocument& document) {
  Json result = Json::object();
  result["windows"] = Json::array();
  for (const EigenvaluesDocument::Window& window : document.windows) {
    Json& entry = result["windows"].emplace_back(Json::object());
    entry["in"] = interval_json(enclosure(window));
    entry["least"] = window.least;
    entry["most"] = window.most;
    if (window.least != window.most) continue;
    entry["smallest"] = interval_json(window.smallest);
    entry["greatest"] = interval_json(window.greatest);
  }
  result["eigenvalues_up_to"] = document.eigenvalues_up_to;
  if (document.eigenvalues_up_to >= 0.25) {
    const auto [least, most] = below_quarter(document);
    result["below_quarter"] = Json::object({{"least", least}, {"most", most}});
  }
  result["closed_geodesics"] = document.geodesics.size();
  result["up_to"] = document.up_to;
  if (const auto needed = length_to_count_first(document)) result["up_to_needed"] = std::ceil(*needed);
  return result;
}

void find_eigenvalues(const EigenvaluesRequest& request) {
  check_files({{"SURFACE", request.surface}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  EigenvaluesOptions options{.count = request.count, .eigenfunctions = !request.fast, .threads = request.threads};
  if (!request.up_to.empty()) {
    options.up_to = parse_length("--up-to", request.up_to);
    constexpr int kLongest = 30;
    if (options.up_to->value() > kLongest) throw UsageError("--up-to: more than the greatest length, 30");
  }
  if (!request.width.empty()) options.width = static_cast<double>(parse_length("--width", request.width).value());
  if (request.seconds > 0) options.seconds = request.seconds;
  const Surface surface = read_surface_input(request.surface);
  EigenvaluesDocument document;
  certify::Certificate certificate;
  {
    ProgressLine progress;
    options.progress = progress.shower();
    document = eigenvalues(surface, options);
  }
  {
    ProgressLine progress;
    certify::CheckOptions check_options;
    check_options.threads = request.threads;
    check_options.max_work = std::numeric_limits<std::uint64_t>::max();  // No limit, as the document was made here.
    check_options.progress = progress.shower("certificate: ");
    certificate = certify::check(document, check_options);
  }
  if (certificate.verdict != certify::Verdict::verified) {
    throw JobError("not certified: " + certify::verdict_line(certificate) + "; nothing was written");
  }
  const std::string svg = request.svg.empty() ? "" : draw_svg(picture_of(document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  Report report{"verdict: VERIFIED\n", Json::object({{"verdict", "VERIFIED"}})};
  const Report contents = eigenvalues_report(document);
  report.text += contents.text;
  report.json.update(contents.json);
  write_report(report, request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report eigenvalues_report(const EigenvaluesDocument& document) {
  return {eigenvalues_text(document), eigenvalues_json(document)};
}

void add_eigenvalues_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<EigenvaluesRequest>();
  CLI::App* command = app.add_subcommand(
      "eigenvalues",
      "Eigenvalues of the Laplacian: intervals with their numbers of eigenvalues, from 0 on without a gap, proved.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  command
      ->add_option("--up-to", shared->up_to,
                   "use the closed geodesics up to this length, at most 30; time proportional to e^L, and more "
                   "eigenvalues. With --width or --time: the greatest length [16 or 30], after smaller ones, from 8 on")
      ->option_text("L [10]");
  command
      ->add_option("--width", shared->width,
                   "take closed geodesics of more and more lengths until the first eigenvalue, or the first N of "
                   "--count, are counted, each in an interval that is narrower than W")
      ->option_text("W");
  command
      ->add_option("--time", shared->seconds,
                   "take closed geodesics of more and more lengths until about so many seconds are used, the "
                   "certificate included: how far that leads depends on the machine")
      ->check(integer_between(1, 1'000'000))
      ->option_text("SECONDS");
  command->add_option("--count", shared->count, "stop when so many eigenvalues are found")
      ->check(integer_between(1, 1'000'000))
      ->option_text("N");
  command->add_flag("--fast", shared->fast,
                    "no approximate eigenfunctions, which enclose counted eigenvalues to some nine digits: seconds "
                    "less for each interval");
  add_file(*command, "-o,--output", shared->output,
           "the eigenvalues file to write, for certify; \"-\" is standard output");
  add_file(
      *command, "--svg", shared->svg,
      "also draw the bound for the number of eigenvalues at each place, and the intervals; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Example:\n  epsnet eigenvalues s.json\n  epsnet eigenvalues s.json --up-to 12 -o eigenvalues.json && certify "
      "eigenvalues.json\n  epsnet eigenvalues s.json --width 1e-6\n  epsnet eigenvalues s.json --time 60 --fast");
  command->callback([&chosen, shared] { chosen = [shared] { find_eigenvalues(*shared); }; });
}

}  // namespace epsnet::program
