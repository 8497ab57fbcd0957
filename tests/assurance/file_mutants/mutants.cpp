#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <variant>
#include <vector>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"
#include "certify/numbers/parallel.h"
#include "netgen/exchange/exchange.h"
#include "netgen/nets/certified_net.h"
#include "netgen/surfaces/fenchel_nielsen.h"
#include "netgen/surfaces/surfaces.h"
#include "tests/assurance/file_mutants/mutations.h"

/// Mutants of files: single and double defects of true files, in the document or in its text. The verdicts of `certify`
/// are compared with those of `certify-exact`.
namespace epsnet::attack {
namespace {

using certify::CurvesDocument;
using certify::DistanceDocument;
using certify::EigenvaluesDocument;
using certify::GeodesicsDocument;
using certify::IsometriesDocument;
using certify::NetDocument;
using certify::PantsDocument;
using certify::Verdict;
using Document = certify::ClaimDocument;

/// A true file, and how often it is used.
struct Base {
  std::string name;
  Document document;
  std::string text;
  unsigned weight;
};

struct Family {
  std::string name;
  unsigned weight;  ///< Its share of the mutants.
  std::vector<Base> bases;
};

std::string written(const Document& document) {
  std::ostringstream out;
  certify::write_file(document, out);
  return out.str();
}

Base base(std::string name, Document document, unsigned weight = 1) {
  std::string text = written(document);
  return {std::move(name), std::move(document), std::move(text), weight};
}
Base net(const std::string& name, const Surface& surface, const char* epsilon, unsigned weight = 1,
         bool pseudo = false) {
  NetOptions options;
  options.pseudo = pseudo;
  options.check.threads = 1;
  return base(name + ", epsilon " + epsilon, certified_net(surface, Length(epsilon), options).document, weight);
}
Base file(const std::string& path, unsigned weight = 1) {
  return base(path, certify::read_file<Document>(EPSNET_TEST_DATA "/" + path), weight);
}
Surface polygon(const std::string& name) {
  return import_surface(certify::load(EPSNET_TEST_DATA "/polygons/" + name + ".txt"), name);
}
Surface cuffs(const PantsGraph& graph, const std::vector<const char*>& lengths) {
  FenchelNielsen coordinates{graph, {}, {}};
  for (const char* length : lengths) {
    coordinates.lengths.push_back(Length(length).value());
    coordinates.twists.push_back(Rational(1, 3) * coordinates.lengths.back());
  }
  return fenchel_nielsen_surface(coordinates);
}

/// A regular octagon, with sides glued of which some numbers have an odd sum.
Surface octagon_of_another_gluing() {
  return Surface::map({8, 8}, {{0, 0, 0, 2}, {0, 1, 0, 4}, {0, 3, 0, 6}, {0, 5, 0, 7}});
}

std::vector<Family> families() {
  std::vector<Family> all;
  const auto add = [&](std::string name, unsigned weight) -> std::vector<Base>& {
    all.push_back({std::move(name), weight, {}});
    return all.back().bases;
  };
  {
    auto& b = add("octagons", 230);
    b.push_back(net("octagon 123", random_octagon(123), "0.9", 2));
    b.push_back(net("octagon 321", random_octagon(321), "0.8", 1));
    b.push_back(net("octagon 7", random_octagon(7), "1.2", 4));
    b.push_back(file("forgeries/octagon.json", 3));
    b.push_back(file("forgeries/symmetric-octagon.json", 3));
    b.push_back(file("forgeries/symmetric-octagon-centre.json", 2));
    b.push_back(file("certify/verified/square-of-cocircular-vertices.json", 2));
  }
  {
    auto& b = add("polygons", 230);
    b.push_back(net("polygon-g2-small", polygon("polygon-g2-small"), "1", 3));
    b.push_back(net("polygon-g2-theta", polygon("polygon-g2-theta"), "1.2", 3));
    b.push_back(net("polygon-g3-small", polygon("polygon-g3-small"), "1.3", 2));
    b.push_back(net("polygon-g3-rnd1", polygon("polygon-g3-rnd1"), "1.3", 1));
    // The octagon 123 as two triangles and a hexagon.
    const Surface octagon = random_octagon(123);
    const Tile& v = octagon.tiles()[0];
    const Surface tiles({{v[0], v[1], v[2]}, {v[4], v[5], v[6]}, {v[0], v[2], v[3], v[4], v[6], v[7]}},
                        {{0, 0, 1, 0}, {0, 1, 1, 1}, {2, 1, 2, 4}, {2, 2, 2, 5}, {0, 2, 2, 0}, {1, 2, 2, 3}});
    b.push_back(net("three tiles", tiles, "1", 3));
  }
  {
    auto& b = add("Fenchel-Nielsen surfaces", 180);
    b.push_back(net("chain of genus 2, random", fenchel_nielsen_surface(random_coordinates(PantsGraph::chain(2), 5)),
                    "1.1", 3));
    b.push_back(
        net("ring of genus 2, random", fenchel_nielsen_surface(random_coordinates(PantsGraph::ring(2), 6)), "1.1", 3));
    b.push_back(
        net("tree of genus 3, random", fenchel_nielsen_surface(random_coordinates(PantsGraph::tree(3), 7)), "1.5", 1));
    b.push_back(net("theta of equal cuffs", cuffs(PantsGraph::ring(2), {"2", "2", "2"}), "1", 2));
  }
  {
    auto& b = add("thin surfaces", 150);
    b.push_back(net("polygon-g2-thin-1e-2", polygon("polygon-g2-thin-1e-2"), "1.5", 4));
    b.push_back(net("polygon-g2-thin-1e-4", polygon("polygon-g2-thin-1e-4"), "2", 1));
    b.push_back(net("a cuff of 1e-3", cuffs(PantsGraph::chain(2), {"2", "0.001", "2.5"}), "1.6", 2));
  }
  {
    auto& b = add("regular nets", 100);
    b.push_back(net("regular of genus 2", Surface::regular(2), "1.2", 2));
    b.push_back(file("forgeries/regular.json", 2));
    b.push_back(file("forgeries/regular-of-one-vertex.json", 3));
    b.push_back(file("certify/verified/regular-2-4-rotated-vertices.json", 4));
    b.push_back(file("certify/verified/regular-3-centre.json", 4));
    b.push_back(net("regular of genus 3", Surface::regular(3), "1.6", 1));
    b.push_back(net("regular of genus 4", Surface::regular(4), "2", 1));
  }
  {
    auto& b = add("maps", 40);
    b.push_back(file("certify/verified/map-klein.json", 1));
    b.push_back(file("certify/verified/map-bring.json", 1));
    b.push_back(net("an octagon of another gluing", octagon_of_another_gluing(), "1.5", 2));
  }
  {
    auto& b = add("number fields", 40);
    b.push_back(file("forgeries/field-bolza.json", 3));
    b.push_back(file("forgeries/field-octagon.json", 2));
    b.push_back(file("forgeries/field-reducible.json", 1));
  }
  {
    auto& b = add("pseudo nets", 60);
    b.push_back(file("forgeries/collars.json", 1));
    b.push_back(net("three cuffs of 0.1", cuffs(PantsGraph::ring(2), {"0.1", "0.12", "0.15"}), "0.346", 2, true));
    b.push_back(net("a cuff of 0.01", cuffs(PantsGraph::chain(2), {"0.2", "0.01", "0.2"}), "0.34", 1, true));
  }
  {
    auto& b = add("geodesics", 25);
    b.push_back(file("forgeries/systole.json", 8));
    b.push_back(file("forgeries/spectrum.json", 8));
    b.push_back(file("forgeries/spectrum-with-a-figure-eight.json", 1));
  }
  {
    auto& b = add("geodesics of regular surfaces", 5);
    b.push_back(file("forgeries/spectrum-of-equal-lengths.json"));
    b.push_back(file("forgeries/maximum.json"));
  }
  {
    auto& b = add("thick-thin decompositions", 20);
    b.push_back(file("forgeries/small-curves.json", 8));
    b.push_back(file("geodesics/three-cuffs.json", 8));
  }
  {
    auto& b = add("distances", 60);
    b.push_back(file("distances/four-equal.json", 3));
    b.push_back(file("distances/zero.json", 1));
    b.push_back(file("distances/across-a-cuff-of-1e-8.json", 1));
    b.push_back(file("distances/bolza.json", 2));
  }
  {
    auto& b = add("bounds", 60);
    b.push_back(file("bounds/octagon-diameter.json", 2));
    b.push_back(file("bounds/octagon-radius.json", 2));
    b.push_back(file("bounds/octagon-embedded-disk.json", 2));
    b.push_back(file("bounds/regular-diameter.json", 2));
    b.push_back(file("bounds/octagon-diameter-base.json", 2));
    b.push_back(file("bounds/octagon-embedded-disk-base.json", 2));
    b.push_back(file("bounds/octagon-diameter-domain.json", 2));
    b.push_back(file("bounds/bolza-radius-domain.json", 2));
  }
  {
    auto& b = add("isometries", 20);
    b.push_back(file("isometries/octagon-5.json", 2));
    b.push_back(file("isometries/bolza.json", 1));
    b.push_back(file("isometries/bolza-of-one-vertex.json", 2));
    b.push_back(file("isometries/fenchel-nielsen-3-1.json", 1));
  }
  {
    auto& b = add("eigenvalues", 20);
    b.push_back(file("eigenvalues/octagon-5.json", 8));
    b.push_back(file("eigenvalues/octagon-5-of-one-vertex.json", 8));
    b.push_back(file("eigenvalues/octagon-sections-of-a-third.json", 8));
    b.push_back(file("eigenvalues/octagon-sections-in-a-box.json", 8));
    b.push_back(file("eigenvalues/bolza.json", 8));
    b.push_back(file("eigenvalues/octagon-5-with-a-function.json", 1));
    b.push_back(file("eigenvalues/bolza-with-three-functions.json", 1));
  }
  {
    auto& b = add("pants decompositions", 20);
    b.push_back(file("pants/octagon-5.json", 3));
    b.push_back(file("pants/bolza.json", 2));
    b.push_back(file("pants/fenchel-nielsen-2.json", 2));
    b.push_back(file("pants/cuff-1e-12.json", 1));
  }
  {
    auto& b = add("closed curves", 20);
    b.push_back(file("curves/octagon-5.json", 3));
    b.push_back(file("curves/bolza.json", 1));
    b.push_back(file("curves/klein.json", 1));
  }
  return all;
}

template <class T>
T& weighted(std::vector<T>& rows, Random& random) {
  unsigned sum = 0;
  for (const T& row : rows) sum += row.weight;
  std::uint32_t at = random.below(sum);
  for (T& row : rows) {
    if (at < row.weight) return row;
    at -= row.weight;
  }
  throw std::logic_error("weights");
}

struct Mutant {
  Family* family;
  Base* base;
  std::string text;
  std::string how;
};

template <class Claim>
std::string own_defect(const std::vector<MutationOf<Claim>>& all, Document& document, Random& random) {
  const MutationOf<Claim>& mutation = all[random.below(all.size())];
  mutation.apply(std::get<Claim>(document), random);
  return mutation.name;
}

/// The same for a claim that rests on a spectrum: a defect of that, too.
template <class Claim>
std::string defect_on_spectrum(const std::vector<MutationOf<Claim>>& all, Document& document, Random& random) {
  if (random.below(4) != 0) return own_defect(all, document, random);
  const auto& mutation = geodesics_mutations()[random.below(geodesics_mutations().size())];
  mutation.apply(std::get<Claim>(document), random);
  return mutation.name;
}

/// The net of a document that is one or has one.
NetDocument& net_of(Document& document) {
  return std::visit(
      [](auto& claim) -> NetDocument& {
        if constexpr (requires { claim.net; }) {
          return claim.net;
        } else {
          return claim;
        }
      },
      document);
}

/// Makes one defect in the document; returns its name.
std::string defect(Document& document, Random& random) {
  if (!std::holds_alternative<NetDocument>(document) && random.below(5) != 0) {
    if (std::holds_alternative<GeodesicsDocument>(document)) {
      return own_defect(geodesics_mutations(), document, random);
    }
    if (std::holds_alternative<EigenvaluesDocument>(document)) {
      return own_defect(eigenvalues_mutations(), document, random);
    }
    if (std::holds_alternative<IsometriesDocument>(document)) {
      return defect_on_spectrum(isometries_mutations(), document, random);
    }
    if (std::holds_alternative<CurvesDocument>(document)) return own_defect(curves_mutations(), document, random);
    if (std::holds_alternative<PantsDocument>(document)) return own_defect(pants_mutations(), document, random);
    if (std::holds_alternative<DistanceDocument>(document)) return own_defect(distance_mutations(), document, random);
    return own_defect(bound_mutations(), document, random);
  }
  NetDocument& net = net_of(document);
  const bool regular = net.surface.regular_genus != 0 && random.below(4) == 0;
  const bool field = !net.surface.field.polynomial.empty() && random.below(2) == 0;
  const bool collars = net.collars && random.below(5) < 3;
  const std::vector<Mutation>& list = collars   ? collar_mutations()
                                      : regular ? regular_mutations()
                                      : field   ? field_mutations()
                                                : mutations();
  const Mutation& mutation = list[random.below(list.size())];
  mutation.apply(net, random);
  return mutation.name;
}

/// Returns the mutant of this number, which depends only on the seed and the number.
Mutant make(std::vector<Family>& all, std::uint64_t seed, std::uint64_t number) {
  Random random(seed * 0x9E3779B97F4A7C15U + number);
  Family& family = weighted(all, random);
  Base& base = weighted(family.bases, random);
  const bool bytes = random.below(8) == 0;
  const bool twice = random.below(2) == 0;
  for (;;) {
    Mutant mutant{&family, &base, base.text, {}};
    if (bytes) {
      for (unsigned i = 0; i < 1U + (twice ? 1U : 0U);) {
        try {
          change_text(mutant.text, random);
          ++i;
        } catch (const NothingToChange&) {
        }
      }
      mutant.how = "bytes";
    } else {
      Document document = base.document;
      try {
        mutant.how = defect(document, random);
      } catch (const NothingToChange&) {
        continue;
      } catch (const std::out_of_range&) {
        continue;
      }
      if (twice) {
        // After the first defect there may be nothing left to which a second one applies.
        Document second = document;
        try {
          const std::string name = defect(second, random);
          document = std::move(second);
          mutant.how += "; " + name;
        } catch (const NothingToChange&) {
        } catch (const std::out_of_range&) {
        } catch (const std::invalid_argument&) {
        }
      }
      mutant.text = written(document);
    }
    if (mutant.text != base.text) return mutant;
  }
}

struct Opinion {
  Verdict verdict = Verdict::undecided;
  std::string rule;
  std::string message;
};

Opinion ask_certify(const std::string& text) {
  try {
    const auto document = certify::parse_file<certify::ClaimDocument>(text, "mutant");
    const certify::CheckOptions options{.threads = 1, .max_precision = 4096};
    const certify::Certificate c = certify::check(document, options);
    return {c.verdict, c.rule, c.message};
  } catch (const certify::MalformedError& error) {
    return {Verdict::malformed, "", error.what()};
  }
}

Opinion ask_exact(const std::string& text) {
  const exact::Result result = exact::check(text);
  constexpr std::array<Verdict, 4> kVerdicts{Verdict::verified, Verdict::refuted, Verdict::undecided,
                                             Verdict::malformed};
  return {kVerdicts.at(static_cast<std::size_t>(result.verdict)), result.rule, result.message};
}

bool decided(const Opinion& opinion) { return opinion.verdict != Verdict::undecided; }
/// Whether both decide, with different verdicts.
bool disagree(const Opinion& one, const Opinion& other) {
  return decided(one) && decided(other) && one.verdict != other.verdict;
}

/// A row of the table.
struct Row {
  std::uint64_t mutants = 0;
  std::array<std::uint64_t, 4> verdict{};  ///< Counts of the verdicts of `certify`, by Verdict.
  std::uint64_t exact_undecided = 0;       ///< Those that `certify-exact` leaves undecided.
  std::uint64_t other_rules = 0;           ///< Both refute, by different rules.
  std::uint64_t disagreements = 0;

  void operator+=(const Row& other) {
    mutants += other.mutants;
    for (std::size_t i = 0; i < 4; ++i) verdict.at(i) += other.verdict.at(i);
    exact_undecided += other.exact_undecided;
    other_rules += other.other_rules;
    disagreements += other.disagreements;
  }
};

struct Options {
  std::uint64_t mutants = 1000;
  std::uint64_t first = 0;
  std::uint64_t seed = 1;
  unsigned jobs = 1;
  std::string family;  ///< The only one, or empty.
  std::filesystem::path folder = ".";
  std::filesystem::path keep;  ///< A folder for all mutants, or empty.
  bool details = false;
};

class Attack {
 public:
  Attack(const Options& options, std::vector<Family> all)
      : options_(options), families_(std::move(all)), next_(options.first) {
    for (const Family& family : families_) rows_[family.name];
  }

  /// Whether there was no disagreement.
  bool run() {
    for (const Family& family : families_) {
      for (const Base& base : family.bases) unspoilt(base);
    }
    certify::for_each_parallel(options_.jobs, options_.jobs, [this](unsigned, std::size_t) { work(); });
    if (terminal_) std::fputs("\r                                        \r", stderr);
    print();
    return failures_ == 0;
  }

 private:
  /// Checks that both checkers verify the true file.
  void unspoilt(const Base& base) {
    const Opinion first = ask_certify(base.text);
    const Opinion second = ask_exact(base.text);
    if (first.verdict == Verdict::verified && second.verdict == Verdict::verified) return;
    std::cerr << base.name << ": certify: " << first.message << "; certify-exact: " << second.message << '\n';
    ++failures_;
  }

  void work() {
    std::map<std::string, Row> rows;
    for (;;) {
      const std::uint64_t number = next_++;
      if (number >= options_.first + options_.mutants) break;
      const Mutant mutant = make(families_, options_.seed, number);
      examine(mutant, number, rows[mutant.family->name]);
      if (terminal_ && number % 64 == 0) progress(number - options_.first);
    }
    const std::lock_guard lock(mutex_);
    for (const auto& [name, row] : rows) rows_[name] += row;
  }

  void examine(const Mutant& mutant, std::uint64_t number, Row& row) {
    const auto start = std::chrono::steady_clock::now();
    const Opinion first = ask_certify(mutant.text);
    const auto between = std::chrono::steady_clock::now();
    const Opinion second = ask_exact(mutant.text);
    const auto end = std::chrono::steady_clock::now();
    ++row.mutants;
    ++row.verdict.at(static_cast<std::size_t>(first.verdict));
    if (!decided(second)) ++row.exact_undecided;
    const bool refuted = first.verdict == Verdict::refuted && second.verdict == Verdict::refuted;
    if (refuted && first.rule != second.rule) ++row.other_rules;
    if (!options_.keep.empty()) {
      std::ofstream(options_.keep / (std::to_string(number) + ".json"), std::ios::binary) << mutant.text;
    }
    const auto said = [](const Opinion& opinion) {
      return std::string(certify::name(opinion.verdict)) + " " + opinion.rule + " " + opinion.message;
    };
    if (options_.details) {
      const auto ms = [](auto a, auto b) { return std::chrono::duration<double, std::milli>(b - a).count(); };
      const std::lock_guard lock(mutex_);
      std::cout << number << '\t' << mutant.base->name << '\t' << mutant.how << '\t' << said(first) << '\t'
                << said(second) << '\t' << ms(start, between) << '\t' << ms(between, end) << '\n';
    }
    if (!disagree(first, second)) return;
    ++row.disagreements;
    const std::filesystem::path path =
        options_.folder / ("disagreement-" + std::to_string(options_.seed) + "-" + std::to_string(number) + ".json");
    const std::lock_guard lock(mutex_);
    ++failures_;
    std::ofstream(path, std::ios::binary) << mutant.text;
    std::cerr << path.string() << ": " << mutant.base->name << ", " << mutant.how << ": certify: " << said(first)
              << ", certify-exact: " << said(second) << '\n';
  }

  void progress(std::uint64_t done) {
    const std::lock_guard lock(mutex_);
    std::fprintf(stderr, "\r%llu of %llu mutants", static_cast<unsigned long long>(done),
                 static_cast<unsigned long long>(options_.mutants));
  }

  void print() const {
    std::cout << "| family | mutants | VERIFIED | REFUTED | MALFORMED | UNDECIDED | UNDECIDED by `certify-exact` | "
                 "refuted by another rule | disagreements |\n"
                 "| --- | --: | --: | --: | --: | --: | --: | --: | --: |\n";
    Row sum;
    const auto line = [](const std::string& name, const Row& row) {
      std::cout << "| " << name << " | " << row.mutants;
      for (const Verdict v : {Verdict::verified, Verdict::refuted, Verdict::malformed, Verdict::undecided}) {
        std::cout << " | " << row.verdict.at(static_cast<std::size_t>(v));
      }
      std::cout << " | " << row.exact_undecided << " | " << row.other_rules << " | " << row.disagreements << " |\n";
    };
    for (const Family& family : families_) {
      line(family.name, rows_.at(family.name));
      sum += rows_.at(family.name);
    }
    line("all", sum);
  }

  Options options_;
  std::vector<Family> families_;
  std::atomic<std::uint64_t> next_;
  std::map<std::string, Row> rows_;
  std::mutex mutex_;
  std::atomic<std::uint64_t> failures_ = 0;
  bool terminal_ = isatty(STDERR_FILENO) != 0;
};

}  // namespace
}  // namespace epsnet::attack

int main(int argc, char** argv) try {
  epsnet::attack::Options options;
  CLI::App app{
      "Mutants of files of all claims: single and double defects, in the document or in its bytes.\n"
      "What certify says of each is compared with certify-exact. A mutant on which they disagree is written to a "
      "file,\n"
      "and the exit code is 1. Example: attack_mutants --mutants 1000000 --jobs 2"};
  app.add_option("--mutants", options.mutants, "How many")->capture_default_str();
  app.add_option("--seed", options.seed, "Chooses all of them")->capture_default_str();
  app.add_option("--first", options.first, "The number of the first one, to make a single one again")
      ->capture_default_str();
  app.add_option("--family", options.family, "Only files of this family; a number names another mutant than with all");
  app.add_option("--jobs", options.jobs, "Threads; the table is the same for any number")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  app.add_option("--folder", options.folder, "Where mutants that the checkers disagree about go")
      ->capture_default_str();
  app.add_option("--keep", options.keep, "A folder into which all mutants are written")->check(CLI::ExistingDirectory);
  app.add_flag("--details", options.details, "A line for each mutant: base, defects, verdicts, milliseconds");
  CLI11_PARSE(app, argc, argv);
  std::vector<epsnet::attack::Family> families = epsnet::attack::families();
  if (!options.family.empty()) {
    std::erase_if(families, [&](const auto& family) { return family.name != options.family; });
    if (families.empty()) throw std::invalid_argument("no family is called " + options.family);
  }
  return epsnet::attack::Attack(options, std::move(families)).run() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "attack_mutants: " << error.what() << '\n';
  return 70;
}
