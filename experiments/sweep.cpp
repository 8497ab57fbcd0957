#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "certify/base/interval.h"
#include "certify/check.h"
#include "certify/numbers/parallel.h"
#include "experiments/record_file.h"
#include "netgen/base/atomic_file.h"
#include "netgen/base/options.h"
#include "netgen/base/progress_line.h"
#include "netgen/geodesics/geodesics.h"
#include "netgen/nets/certified_net.h"
#include "netgen/nets/net_record.h"
#include "netgen/surfaces/surface_file.h"

/// The program `sweep`: makes certified nets of many surfaces for many ε, or their certified systoles, several surfaces
/// at a time, and writes a file of records for each.
namespace epsnet::experiments {
namespace {

constexpr int kExitFailed = 1;
constexpr int kExitUsage = 64;

struct Request {
  std::vector<std::string> surfaces;
  std::vector<std::string> epsilons;
  bool systoles = false;
  std::string output;
  unsigned threads = 0;
  NetOptions options;
};

/// One surface and the file of its records.
struct Job {
  std::filesystem::path surface;
  std::filesystem::path records;
  std::string head;  ///< The head of its file of records.
};

std::size_t records_per_surface(const Request& request) { return request.systoles ? 1 : request.epsilons.size(); }

/// Returns the processor time of the calling thread, which excludes the other surfaces.
double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Makes and proves a net, and returns its record. Throws NetError.
std::string certified_record(const std::string& name, const Surface& surface, const Length& epsilon,
                             const NetOptions& options) {
  const double start = processor_seconds();
  const UncertifiedNet net = compute_net(surface, epsilon, options);
  const double computed = processor_seconds();
  const certify::Certificate certificate = certify::check(net.net, options.check);
  if (certificate.verdict != certify::Verdict::verified)
    throw NetError("epsilon " + epsilon.text() + ": the net was not verified: " + certificate.rule + ": " +
                   certificate.message);
  return net_record(name, net, certificate, options, {computed - start, processor_seconds() - computed});
}

/// Finds and proves a systole, and returns its record. Throws NetError.
std::string systole_record(const std::string& name, const Surface& surface) {
  constexpr unsigned kThreads = 1;
  const double start = processor_seconds();
  const certify::GeodesicsDocument document = unproved::systole(surface, {.threads = kThreads});
  const double computed = processor_seconds();
  const certify::Certificate certificate = certify::check(document, {.threads = kThreads});
  if (certificate.verdict != certify::Verdict::verified)
    throw NetError("the systole was not verified: " + certificate.rule + ": " + certificate.message);
  const certify::GeodesicsDocument::ClosedGeodesic& geodesic = document.geodesics.front();
  std::ostringstream record;
  record << name << ',' << certify::name(certificate.verdict) << ',' << surface.genus() << ','
         << certify::decimal_below(geodesic.length.lower) << ',' << certify::decimal_above(geodesic.length.upper) << ','
         << (geodesic.simple ? "yes" : "no") << ',' << computed - start << ',' << processor_seconds() - computed;
  return record.str();
}

constexpr const char* kSystoleColumns =
    "surface,verdict,genus,systole_lower,systole_upper,simple,search_seconds,certificate_seconds";

/// Distributes the surfaces among threads, and reports failures and progress.
class Sweep {
 public:
  Sweep(const Request& request, std::vector<Job> jobs) : request_(request), jobs_(std::move(jobs)) {
    for (const std::string& epsilon : request.epsilons) epsilons_.emplace_back(epsilon);
  }

  /// Returns the number of surfaces that failed, each with a line on standard error.
  std::size_t run() {
    certify::for_each_parallel(jobs_.size(), request_.threads, [this](unsigned, std::size_t i) {
      try {
        make(jobs_[i]);
      } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        ++failures_;
        std::cerr << "sweep: " << jobs_[i].surface.string() << ": " << error.what() << '\n';
      }
    });
    return failures_;
  }

 private:
  void make(const Job& job) {
    const Surface surface = load_surface(job.surface);
    const std::string name = job.surface.stem().string();
    std::vector<std::string> records;
    if (request_.systoles) {
      records.push_back(systole_record(name, surface));
      show_progress();
    }
    for (const Length& epsilon : epsilons_) {
      records.push_back(certified_record(name, surface, epsilon, request_.options));
      show_progress();
    }
    write_file_atomically(job.records, [&](std::ostream& out) { out << record_file(job.head, records); });
  }

  void show_progress() {
    const std::lock_guard lock(mutex_);
    const std::size_t all = jobs_.size() * records_per_surface(request_);
    ++nets_;
    progress_.show(std::to_string(nets_) + " of " + std::to_string(all) + (request_.systoles ? " systoles" : " nets"),
                   static_cast<double>(nets_) / static_cast<double>(all));
  }

  const Request& request_;
  std::vector<Job> jobs_;
  std::vector<Length> epsilons_;
  std::mutex mutex_;  // Guards everything below.
  std::size_t nets_ = 0;
  std::size_t failures_ = 0;
  ProgressLine progress_;
};

/// Returns the parameters, besides the surface, on which the records depend, and the names of their columns.
std::string way(const Request& request) {
  if (request.systoles) return std::string("systole\n") + kSystoleColumns;
  std::string result = "insertion ";
  result.append(name(request.options.insertion)).append(", walk ").append(name(request.options.walk));
  result.append(", list ").append(name(request.options.list.value_or(TriangleList::large_back))).append(", epsilon");
  for (const std::string& epsilon : request.epsilons) result += ' ' + epsilon;
  return result + '\n' + net_record_columns();
}

/// Returns the surfaces without a finished file. The head of a file names the bytes of the surface, not its path.
std::vector<Job> unfinished(const Request& request) {
  std::vector<Job> jobs;
  for (const std::filesystem::path surface : request.surfaces) {
    const std::string stem = surface.stem().string();
    const std::string head =
        parameter_line("surface " + stem + ' ' + checksum(read_file(surface)) + ", " + way(request));
    const std::filesystem::path records = std::filesystem::path(request.output) / (stem + ".csv");
    if (!is_finished(records, head, records_per_surface(request))) jobs.push_back({surface, records, head});
  }
  return jobs;
}

void check(const Request& request) {
  std::set<std::string> stems;
  for (const std::filesystem::path surface : request.surfaces)
    if (!stems.insert(surface.stem().string()).second)
      throw std::invalid_argument("two surfaces are called " + surface.stem().string());
  if (request.systoles != request.epsilons.empty()) throw std::invalid_argument("either --epsilons or --systoles");
  for (const std::string& epsilon : request.epsilons) (void)Length(epsilon);
}

int run(int argc, char** argv) {
  Request request;
  CLI::App app("Certified epsilon-nets of many surfaces, a file of records (CSV) for each.", "sweep");
  app.add_option("SURFACE", request.surfaces, "surface files")->required();
  app.add_option("--epsilons", request.epsilons, "of nets, separated by commas")->delimiter(',');
  app.add_flag("--systoles", request.systoles, "systoles instead of nets");
  app.add_option("-o,--output", request.output, "an existing directory; finished files in it are kept")->required();
  app.add_option("--threads", request.threads, "surfaces at the same time; 0 is one per core");
  app.add_option("--insert", request.options.insertion, "cavity or flips")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, Insertion>(kInsertionNames.begin(), kInsertionNames.end())));
  app.add_option("--locate", request.options.walk, "visibility or straight")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Walk>(kWalkNames.begin(), kWalkNames.end())));
  app.add_option("--list", request.options.list, "A, B, C or D, as in epsnet net")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, TriangleList>(kTriangleListNames.begin(), kTriangleListNames.end())));
  try {
    app.parse(argc, argv);
    check(request);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const std::exception& error) {
    std::cerr << "sweep: " << error.what() << " (try --help)\n";
    return kExitUsage;
  }
  if (request.threads == 0) request.threads = std::max(1U, std::thread::hardware_concurrency());
  request.options.threads = 1;
  request.options.check.threads = 1;

  if (!std::filesystem::is_directory(request.output)) throw std::runtime_error(request.output + ": no such directory");
  std::vector<Job> jobs = unfinished(request);
  std::cout << "sweep: " << request.surfaces.size() << " surfaces, " << request.surfaces.size() - jobs.size()
            << " finished before" << std::endl;
  const std::size_t failures = Sweep(request, std::move(jobs)).run();
  if (failures > 0) std::cerr << "sweep: " << failures << " surfaces failed\n";
  return failures > 0 ? kExitFailed : 0;
}

}  // namespace
}  // namespace epsnet::experiments

int main(int argc, char** argv) {
  try {
    return epsnet::experiments::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "sweep: " << error.what() << '\n';
    return 1;
  }
}
