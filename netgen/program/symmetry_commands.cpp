#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "certify/base/text.h"
#include "certify/file/file.h"
#include "netgen/base/progress_line.h"
#include "netgen/isometries/isometries.h"
#include "netgen/pants/pants.h"
#include "netgen/pictures/pictures.h"
#include "netgen/program/commands.h"
#include "netgen/program/files.h"

/// The command pants: a pants decomposition of a surface, and its Fenchel–Nielsen coordinates.

namespace epsnet::program {

// The commands isometries and isometric: the symmetries of a surface, and whether two surfaces are the same.

namespace {

struct IsometriesRequest {
  std::string surface;
  std::string other;
  std::string output;
  bool json = false;
  unsigned threads = 0;
};

const char* orientation_text(bool preserves) { return preserves ? "preserves orientation" : "reverses orientation"; }

/// A line for each image of a generator.
void write_images(std::ostream& out, const std::vector<Word>& words, const SurfaceIsometry& isometry) {
  for (std::size_t k = 0; k < words.size(); ++k) {
    out << "  " << word_text(words[k]) << " -> " << word_text(isometry.images[k]) << '\n';
  }
}

Json isometry_json(const SurfaceIsometry& isometry) {
  return Json::object({{"preserves_orientation", isometry.preserves_orientation}, {"images", isometry.images}});
}

IsometryOptions options_of(const IsometriesRequest& request, ProgressLine& progress) {
  IsometryOptions result;
  result.threads = request.threads;
  result.progress = progress.shower();
  return result;
}

/// The isometries of a surface, with the file that proves that they are all, if there is one.
struct Isometries {
  IsometryGroup group;
  std::optional<certify::IsometriesDocument> proof;
  certify::Certificate certificate;
};

/// Throws NotCertifiedError if there is no proof, but a file to write.
Isometries isometries_of(const Surface& surface, const IsometriesRequest& request) {
  ProgressLine progress;
  const IsometryOptions options = options_of(request, progress);
  IsometryGroup group = isometries(surface, options);
  try {
    auto [document, certificate] = certified_isometries(surface, group, options);
    return {std::move(group), std::move(document), std::move(certificate)};
  } catch (const NotCertifiedError& error) {
    if (!request.output.empty()) throw;
    return {std::move(group), std::nullopt, error.certificate()};
  }
}

Json group_json(const IsometryGroup& group, const std::vector<Word>& words) {
  Json json = Json::object({{"order", group.size()}, {"orientation_preserving", group.orientation_preserving()}});
  if (const std::string name = group.name(); !name.empty()) json["name"] = name;
  json["words"] = words;
  json["generators"] = group.generators();
  json["isometries"] = Json::array();
  for (std::uint32_t i = 0; i < group.size(); ++i) {
    Json& entry = json["isometries"].emplace_back(isometry_json(group.isometry(i)));
    entry["order"] = group.order(i);
    if (const auto count = group.fixed_points(i)) entry["fixed_points"] = *count;
  }
  return json;
}

std::string group_text(const IsometryGroup& group, const std::vector<Word>& words) {
  std::ostringstream out;
  out << "isometries: " << group.size() << ", of which " << group.orientation_preserving() << " preserve orientation\n";
  if (const std::string name = group.name(); !name.empty()) out << "group: " << name << '\n';
  // By kind: orientation, order, fixed points; −1 where they are not points alone.
  std::map<std::tuple<bool, std::uint32_t, std::int64_t>, std::size_t> kinds;
  for (std::uint32_t i = 0; i < group.size(); ++i) {
    const auto points = group.fixed_points(i);
    ++kinds[{!group.preserves_orientation(i), group.order(i), points ? static_cast<std::int64_t>(*points) : -1}];
  }
  for (const auto& [kind, count] : kinds) {
    const auto& [reverses, order, points] = kind;
    out << count << " of order " << order << ", " << orientation_text(!reverses);
    if (points >= 0) out << ", " << points << (points == 1 ? " fixed point" : " fixed points");
    out << '\n';
  }
  for (const std::uint32_t g : group.generators()) {
    out << "generator " << g << ": order " << group.order(g) << ", " << orientation_text(group.preserves_orientation(g))
        << '\n';
    write_images(out, words, group.isometry(g));
  }
  return out.str();
}

/// The closed geodesics on which it rests that these are all.
std::string geodesics_used_text(const Isometries& found) {
  const certify::GeodesicsDocument& used = found.proof ? *found.proof : found.group.geodesics();
  return "closed geodesics used: " + std::to_string(used.geodesics.size()) + ", of length at most " + used.up_to +
         '\n' +
         (found.proof
              ? ""
              : "each of these is an isometry, decided by exact numbers; that there is no other one is computed "
                "with 512 bits\n");
}

void list_isometries(const IsometriesRequest& request) {
  check_files({{"SURFACE", request.surface}}, {{"--output", request.output, FileType::json}});
  const Surface surface = read_surface_input(request.surface);
  const Isometries found = isometries_of(surface, request);
  const std::string verdict = certify::verdict_line(found.certificate);
  const std::vector<Word> words = generator_words(surface);
  Report report;
  if (request.json) {
    report.json["verdict"] = certify::name(found.certificate.verdict);
    report.json.update(group_json(found.group, words));
  } else {
    report.text = "verdict: " + verdict + '\n' + group_text(found.group, words) + geodesics_used_text(found);
  }
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(*found.proof, out); }}});
  write_report(report, request.json, is_stdout(request.output));
  if (!found.proof) throw UndecidedError(verdict);
}

std::string near_text(const NearIsometry& near) {
  return "near: a marking that " + std::string(near.marking.preserves_orientation ? "preserves" : "reverses") +
         " orientation, by which traces differ by at most " + certify::decimal_above(near.difference, 2);
}

const char* answer_text(IsometricAnswer::Kind kind) {
  if (kind == IsometricAnswer::Kind::yes) return "yes";
  return kind == IsometricAnswer::Kind::no ? "no" : "undecided";
}

void compare_surfaces(const IsometriesRequest& request) {
  check_files({{"SURFACE", request.surface}, {"OTHER", request.other}}, {{"--output", request.output, FileType::json}});
  const Surface surface = read_surface_input(request.surface);
  const Surface other = read_surface_input(request.other);
  const IsometricAnswer answer = [&] {
    ProgressLine progress;
    return isometric(surface, other, options_of(request, progress));
  }();
  const std::vector<Word> words = generator_words(surface);
  Report report;
  report.json["isometric"] = answer_text(answer.kind);
  if (!answer.reason.empty()) report.json["reason"] = answer.reason;
  std::ostringstream out;
  out << "isometric: " << answer_text(answer.kind) << '\n';
  if (!answer.reason.empty()) out << "reason: " << answer.reason << '\n';
  if (answer.isometry) {
    report.json["words"] = words;
    report.json["isometry"] = isometry_json(*answer.isometry);
    out << "isometry: " << orientation_text(answer.isometry->preserves_orientation) << '\n';
    write_images(out, words, *answer.isometry);
  }
  if (answer.near) {
    report.json["words"] = words;
    report.json["near"] = isometry_json(answer.near->marking);
    report.json["near"]["difference"] = answer.near->difference;
    out << near_text(*answer.near) << '\n';
    write_images(out, words, answer.near->marking);
  }
  if (answer.proof) {
    report.json["verdict"] = certify::name(answer.proof->certificate.verdict);
    out << "verdict: " << certify::verdict_line(answer.proof->certificate) << '\n';
  } else if (answer.kind == IsometricAnswer::Kind::yes) {
    out << "decided by this program alone, with exact numbers that are too large for certify\n";
    if (!request.output.empty()) throw UndecidedError("no file: the exact numbers are too large for certify");
  }
  report.text = out.str();
  if (answer.proof) {
    write_outputs({{request.output, [&](std::ostream& file) { certify::write_file(answer.proof->document, file); }}});
  }
  write_report(report, request.json, is_stdout(request.output));
  if (answer.kind == IsometricAnswer::Kind::undecided) throw UndecidedError("undecided: " + answer.reason);
}

}  // namespace

Report isometries_report(const certify::IsometriesDocument& document) {
  std::ostringstream out;
  out << "isometries: " << document.order << '\n';
  Json generators = Json::array();
  for (std::size_t i = 0; i < document.isometries.size(); ++i) {
    const bool preserves = document.isometries[i].preserves_orientation;
    out << "generator " << i << ": " << orientation_text(preserves) << '\n';
    generators.push_back(Json::object({{"preserves_orientation", preserves}}));
  }
  out << "closed geodesics used: " << document.geodesics.size() << ", of length at most " << document.up_to << '\n';
  return {out.str(), Json::object({{"order", document.order},
                                   {"generators", std::move(generators)},
                                   {"closed_geodesics", document.geodesics.size()},
                                   {"up_to", document.up_to}})};
}

Report comparison_report(const certify::ComparisonDocument& document) {
  const bool isometric = document.relation == certify::ComparisonDocument::Relation::isometric;
  Report report{std::string("isometric: ") + (isometric ? "yes" : "no") + '\n',
                Json::object({{"isometric", isometric}})};
  if (isometric) {
    const bool preserves = document.isometry.preserves_orientation;
    report.text += std::string("isometry: ") + orientation_text(preserves) + '\n';
    report.json["preserves_orientation"] = preserves;
    return report;
  }
  const std::pair<const char*, const certify::GeodesicsDocument&> lists[] = {{"surface", document},
                                                                             {"other", document.other}};
  for (const auto& [name, list] : lists) {
    report.text += std::string("closed geodesics of the ") +
                   (std::string_view(name) == "other" ? "other one" : "first surface") + ": " +
                   std::to_string(list.geodesics.size()) + ", of length at most " + list.up_to + '\n';
    report.json[name] = Json::object({{"closed_geodesics", list.geodesics.size()}, {"up_to", list.up_to}});
  }
  return report;
}

namespace {

void identify_surface(const IsometriesRequest& request) {
  check_files({{"SURFACE", request.surface}}, {});
  const Surface surface = read_surface_input(request.surface);
  const std::vector<NamedAnswer> answers = [&] {
    ProgressLine progress;
    return identify(surface, options_of(request, progress));
  }();
  Report report;
  std::ostringstream out;
  std::string undecided;
  report.json["name"] = nullptr;
  report.json["names"] = Json::array();
  report.json["compared"] = Json::array();
  for (const auto& [names, compared, answer] : answers) {
    const std::string& name = names.front();
    report.json["compared"].push_back(
        Json::object({{"name", name}, {"names", names}, {"isometric", answer_text(answer.kind)}}));
    if (answer.kind == IsometricAnswer::Kind::undecided) undecided += (undecided.empty() ? "" : ", ") + name;
    if (answer.kind != IsometricAnswer::Kind::yes) continue;
    const std::vector<Word> words = generator_words(surface);
    report.json["name"] = name;
    report.json["names"] = names;
    report.json["words"] = words;
    report.json["to"] = compared;
    report.json["isometry"] = isometry_json(*answer.isometry);
    out << "name: " << name << '\n';
    if (names.size() > 1) out << "also:";
    for (std::size_t i = 1; i < names.size(); ++i) out << ' ' << names[i];
    if (names.size() > 1) out << '\n';
    out << "about: " << named_surface(name).about().substr(name.size() + 2) << "\n";
    out << "isometry to " << compared << ": " << orientation_text(answer.isometry->preserves_orientation) << '\n';
    write_images(out, words, *answer.isometry);
    if (answer.proof) out << "verdict: " << certify::verdict_line(answer.proof->certificate) << '\n';
  }
  if (report.json["name"].is_null()) {
    out << "name: none that is known\n";
    for (const auto& [names, compared, answer] : answers) {
      out << "isometric to " << names.front() << ": " << answer_text(answer.kind) << ": " << answer.reason << '\n';
      if (answer.near) out << near_text(*answer.near) << '\n';
    }
    undecided = undecided.empty() ? "" : "undecided: whether it is " + undecided;
  } else {
    undecided.clear();
  }
  report.text = out.str();
  write_report(report, request.json, false);
  if (!undecided.empty()) throw UndecidedError(undecided);
}

}  // namespace

void add_identify_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<IsometriesRequest>();
  CLI::App* command = app.add_subcommand(
      "identify",
      "The names of a surface: to which of the named surfaces and regular maps of its genus it is isometric.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "\"epsnet surface named --list\" lists the names, among them all regular maps of genus 2 to 10. A surface with "
      "systoles of another length or number is another one; others are compared as by \"epsnet isometric\". Most "
      "surfaces have no name.\n"
      "Exit code 2: undecided, as it is isometric to none of which that could be decided.\n\n"
      "Example:\n  epsnet surface matrices klein.txt -o s.json\n  epsnet identify s.json");
  command->callback([&chosen, shared] { chosen = [shared] { identify_surface(*shared); }; });
}

void add_isometries_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<IsometriesRequest>();
  CLI::App* command = app.add_subcommand(
      "isometries",
      "The isometries of one surface with itself: the order of their group, proved, and its elements by what they do "
      "with the generators.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  add_file(*command, "-o,--output", shared->output,
           "the isometries file to write, for certify; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Exit code 2: undecided, as closed geodesics do not prove that there are no other isometries.\n\n"
      "Example:\n  epsnet surface named klein -o klein.json\n"
      "  epsnet isometries klein.json -o isometries.json && certify isometries.json");
  command->callback([&chosen, shared] { chosen = [shared] { list_isometries(*shared); }; });
}

void add_isometric_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<IsometriesRequest>();
  CLI::App* command = app.add_subcommand(
      "isometric", "Whether two surfaces are isometric, proved: an isometry between them, or what tells them apart.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  add_input(*command, "OTHER", shared->other, kSurfaceHelp);
  add_file(
      *command, "-o,--output", shared->output,
      "the comparison file to write, for certify: the isometry, or the closed geodesics that tell the surfaces apart; "
      "\"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "That two surfaces are isometric is proved by exact numbers, also if they are given in different ways: tiles of "
      "other types, or numbers of other fields. That they are not is proved by their genera, or by their closed "
      "geodesics up to some length: how many there are, or where they cross.\n"
      "Exit code 2: undecided, as neither is found, or the exact numbers are too large.\n\n"
      "Example:\n"
      "  epsnet isometric s.json t.json -o comparison.json && certify comparison.json");
  command->callback([&chosen, shared] { chosen = [shared] { compare_surfaces(*shared); }; });
}

namespace {

struct PantsRequest {
  std::string surface;
  std::string curves;
  std::string marking;
  std::string output;
  std::string svg;
  bool find = false;
  bool json = false;
  unsigned threads = 0;
};

Report own_report(const PantsDecomposition& pants) {
  Report report = verified_report();
  Report contents = pants_report(pants.document);
  report.text += contents.text;
  report.json.update(contents.json);
  report.json["own"] = pants.own;
  Json& cuffs = report.json["cuffs"];
  for (std::size_t e = 0; e < pants.cuffs.size(); ++e) cuffs[e]["word"] = pants.cuffs[e].curve;
  report.json["pants"] = pants.pants;
  if (pants.own) report.text += "these are the pants of which the surface was made\n";
  return report;
}

void cut_into_pants(const PantsRequest& request) {
  check_files({{"SURFACE", request.surface}, {"--curves", request.curves}, {"--marking", request.marking}},
              {{"--output", request.output, FileType::json}, {"--svg", request.svg, FileType::svg}});
  const Surface surface = read_surface_input(request.surface);
  std::optional<certify::PantsDocument> marking;
  if (!request.marking.empty()) marking = certify::read_file<certify::PantsDocument>(request.marking);
  PantsOptions options;
  options.own = !request.find;
  options.threads = request.threads;
  std::vector<std::string> names;
  if (!request.curves.empty()) {
    for (const LineText& line : read_lines(request.curves, "curves, expected one on each line, as in 0 3 5")) {
      options.curves.push_back(parse_word(line.name, line.text));
      names.push_back(line.name);
    }
  }
  const PantsDecomposition pants = [&] {
    ProgressLine progress;
    options.progress = progress.shower();
    try {
      return marking ? marked_pants(surface, *marking, options) : pants_decomposition(surface, options);
    } catch (const SurfaceError& error) {
      throw JobError((marking ? request.marking + ": " : "") + error.what());
    } catch (const CurveError& error) {
      throw JobError(names[error.number()] + ": " + error.what());
    }
  }();
  const std::string svg = request.svg.empty() ? "" : svg_of(picture_of(pants.document));
  write_outputs({{request.output, [&](std::ostream& out) { certify::write_file(pants.document, out); }},
                 {request.svg, [&](std::ostream& out) { out << svg; }}});
  write_report(own_report(pants), request.json, is_stdout(request.output) || is_stdout(request.svg));
}

}  // namespace

Report pants_report(const certify::PantsDocument& document) {
  Report report;
  Json& json = report.json;
  std::string graph;
  Json cuffs = Json::array();
  std::ostringstream out;
  for (std::size_t e = 0; e < document.cuffs.size(); ++e) {
    const certify::PantsDocument::Cuff& cuff = document.cuffs[e];
    const auto& [p, k] = cuff.ends[0];
    const auto& [q, l] = cuff.ends[1];
    if (e > 0) graph += ' ';
    graph += std::to_string(p) + '-' + std::to_string(q);
    out << "cuff " << e << " (" << p << '.' << k << '-' << q << '.' << l << "): length " << to_string(cuff.length)
        << ", twist " << to_string(cuff.twist) << '\n';
    Json& entry = cuffs.emplace_back(Json::object({{"ends", {{p, k}, {q, l}}},
                                                   {"length", interval_json(cuff.length)},
                                                   {"twist", interval_json(cuff.twist)},
                                                   {"across", cuff.across}}));
    if (cuff.exp_half_length != 0) {
      out << "  exp(length/2) = " << cuff.exp_half_length.get_str() << ", exactly\n";
      entry["exp_half_length"] = cuff.exp_half_length.get_str();
    }
  }
  json["genus"] = document.pants.size() / 2 + 1;
  json["graph"] = graph;
  json["cuffs"] = std::move(cuffs);
  report.text = "pants: " + std::to_string(document.pants.size()) +
                ", cuffs: " + std::to_string(document.cuffs.size()) + "\ngraph: " + graph + '\n' + out.str();
  return report;
}

void add_pants_command(CLI::App& app, Job& chosen) {
  const auto shared = std::make_shared<PantsRequest>();
  CLI::App* command = app.add_subcommand(
      "pants",
      "A pants decomposition of a surface, and its Fenchel-Nielsen coordinates, in intervals that are proved.");
  add_input(*command, "SURFACE", shared->surface, kSurfaceHelp);
  CLI::Option* curves = add_file(*command, "--curves", shared->curves,
                                 "disjoint simple closed curves to cut along, one on each line, by the numbers of the "
                                 "sides that it crosses; short ones complete them; \"-\" is standard input");
  command
      ->add_flag("--find", shared->find,
                 "look for short curves, also if surface fenchel-nielsen made the surface and its own cuffs are known")
      ->excludes(curves);
  add_file(*command, "--marking", shared->marking,
           "a pants file of a surface with the same tiles, glued alike: cut along its cuffs, with twists that are not "
           "reduced, as its words say")
      ->excludes(curves)
      ->excludes("--find");
  add_file(*command, "-o,--output", shared->output,
           "the pants file to write, for certify and for surface fenchel-nielsen --from; \"-\" is standard output");
  add_file(*command, "--svg", shared->svg, "also draw the cuffs in a Dirichlet domain; \"-\" is standard output");
  add_json(*command, shared->json);
  add_threads(*command, shared->threads);
  command->footer(
      "Twists are given modulo the lengths, between -1/2 and 1/2 of them, but for --marking. docs/fenchel-nielsen.md "
      "has the "
      "conventions.\n\n"
      "Example:\n  epsnet surface octagon --seed 5 -o s.json\n"
      "  epsnet pants s.json -o pants.json && certify pants.json\n"
      "  epsnet surface fenchel-nielsen --from pants.json -o t.json");
  command->callback([&chosen, shared] { chosen = [shared] { cut_into_pants(*shared); }; });
}

}  // namespace epsnet::program
