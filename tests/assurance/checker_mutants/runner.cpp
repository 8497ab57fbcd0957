#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <mutant.h>
#include <mutant_count.h>
#include <regex>
#include <sstream>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "certify/check.h"
#include "certify/exact/checker.h"
#include "certify/file/file.h"

/// Runs the tests of this program against mutants, each in its own process, a fork, which needs no start and no
/// loading.
///
/// runner FILES --reach: runs every test once without a mutant, and prints a line for each: number, milliseconds of
///     processor time, whether it passed, name, numbers of the mutants whose places it reaches.
/// runner FILES --run: reads lines "MUTANT TEST:MILLISECONDS...", and answers each with "MUTANT survived" or
///     "MUTANT failed|crashed|hung TEST", where TEST is the first test that sees it.
///
/// FILES is a folder with the false and true files of forgeries.py and the table `files.tsv`: name, verdict of certify,
/// verdict of certify-exact, further rules, expected message. Each file is a test of each checker. For `certify` it is
/// up to three tests, as a well-formed file must give the same without the filter, and a net also as a compact file.
namespace mutant {
unsigned active = 0;
unsigned char* reached = nullptr;
}  // namespace mutant

namespace {

using namespace epsnet;

struct Shared {
  int test = 0;
  unsigned char reached[MUTANT_COUNT] = {};
};
Shared* shared = nullptr;
// Static objects of the tests may call the checkers before main.
const bool ready = [] {
  shared =
      static_cast<Shared*>(mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  mutant::reached = shared->reached;
  return true;
}();

bool agrees(const std::string& line, const std::string& expected) {
  return (line + ": ").starts_with(expected.ends_with(": ") ? expected : expected + ": ");
}

struct Expected {
  std::string path, certify, exact, also, says;
};

enum class Way { as_it_is, without_filter, compact };

/// Returns a net after a round trip through a compact file; other documents, and nets whose darts are not paired, are
/// returned unchanged.
certify::ClaimDocument through_compact(certify::ClaimDocument claim) {
  const auto* net = std::get_if<certify::NetDocument>(&claim);
  if (net == nullptr) return claim;
  std::ostringstream out;
  try {
    certify::write_compact_net(*net, out);
  } catch (const std::invalid_argument&) {
    return claim;
  }
  return certify::parse_file<certify::NetDocument>(out.str(), "net.epsn");
}

class CertifyFile : public testing::Test {
 public:
  CertifyFile(const Expected& expected, Way way) : expected_(expected), way_(way) {}
  void TestBody() override {
    certify::Certificate certificate;
    try {
      certify::ClaimDocument claim = certify::read_file<certify::ClaimDocument>(expected_.path);
      if (way_ == Way::compact) claim = through_compact(std::move(claim));
      certificate = certify::check(claim, {.threads = 1, .filter = way_ != Way::without_filter});
    } catch (const certify::MalformedError& error) {
      certificate.verdict = certify::Verdict::malformed;
      certificate.message = error.what();
      // After the name of the file.
      const std::size_t place = certificate.message.find(": ", certificate.message.find(".json"));
      if (place != std::string::npos) certificate.message.erase(0, place + 2);
    }
    const std::string line = verdict_line(certificate);
    EXPECT_TRUE(agrees(line, expected_.certify)) << line;
    EXPECT_TRUE(std::regex_search(line, std::regex(expected_.says))) << line;
    std::size_t refuted = 0;
    for (const certify::RuleReport& rule : certificate.rules) {
      if (rule.verdict != certify::Verdict::refuted) continue;
      ++refuted;
      EXPECT_TRUE(expected_.certify.find(": " + rule.rule) != std::string::npos ||
                  ("," + expected_.also + ",").find("," + rule.rule + ",") != std::string::npos)
          << rule.rule;
    }
    EXPECT_EQ(refuted > 0, expected_.certify.starts_with("REFUTED"));
  }

 private:
  const Expected& expected_;
  Way way_;
};

class ExactFile : public testing::Test {
 public:
  explicit ExactFile(const Expected& expected) : expected_(expected) {}
  void TestBody() override {
    std::ifstream in(expected_.path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    const exact::Result result = exact::check(text.str());
    constexpr const char* kNames[] = {"VERIFIED", "REFUTED", "UNDECIDED", "MALFORMED"};
    std::string line = kNames[static_cast<int>(result.verdict)];
    if (!result.rule.empty()) line += ": " + result.rule;
    if (!result.message.empty()) line += ": " + result.message;
    EXPECT_TRUE(agrees(line, expected_.exact)) << line;
    if (!expected_.exact.starts_with("UNDECIDED")) {
      EXPECT_TRUE(std::regex_search(line, std::regex(expected_.says))) << line;
    }
  }

 private:
  const Expected& expected_;
};

std::vector<std::string> fields(const std::string& line, char separator) {
  std::vector<std::string> result(1);
  for (const char c : line) {
    if (c == separator) {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

void register_files(const std::string& folder) {
  std::ifstream table(folder + "/files.tsv");
  static std::vector<std::unique_ptr<Expected>> files;
  for (std::string line; std::getline(table, line);) {
    const auto f = fields(line, '\t');
    files.push_back(std::make_unique<Expected>(Expected{folder + "/" + f[0] + ".json", f[1], f[2], f[3], f[4]}));
    const Expected& expected = *files.back();
    std::string name = f[0];
    std::replace(name.begin(), name.end(), '-', '_');  // A filter takes "-" for "without".
    const auto add = [&](const char* suite, Way way) {
      testing::RegisterTest(suite, name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [&expected, way]() -> CertifyFile* { return new CertifyFile(expected, way); });
    };
    add("FileByCertify", Way::as_it_is);
    if (!expected.certify.starts_with("MALFORMED")) {
      add("FileByBalls", Way::without_filter);
      add("FileAsCompact", Way::compact);
    }
    testing::RegisterTest("FileByExact", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [&expected]() -> ExactFile* { return new ExactFile(expected); });
  }
}

std::vector<std::string> test_names() {
  std::vector<std::string> names;
  const auto* all = testing::UnitTest::GetInstance();
  for (int s = 0; s < all->total_test_suite_count(); ++s) {
    const auto* suite = all->GetTestSuite(s);
    for (int t = 0; t < suite->total_test_count(); ++t)
      names.push_back(std::string(suite->name()) + "." + suite->GetTestInfo(t)->name());
  }
  return names;
}

/// Called every five seconds: ends a process that has used no processor time since the last call, as it waits in vain.
/// Elapsed time is not a criterion, as the machine may be busy with other work.
void end_if_stuck(int) {
  static clock_t before = -CLOCKS_PER_SEC;
  const clock_t now = clock();
  if (now - before < CLOCKS_PER_SEC / 1000) raise(SIGPROF);
  before = now;
}

/// Limits the processor time.
void limit_time(double milliseconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(milliseconds / 1000);
  timer.it_value.tv_usec =
      static_cast<suseconds_t>(1000 * (milliseconds - 1000.0 * static_cast<double>(timer.it_value.tv_sec)));
  setitimer(ITIMER_PROF, &timer, nullptr);
  std::signal(SIGALRM, end_if_stuck);
  const itimerval watch{{5, 0}, {5, 0}};
  setitimer(ITIMER_REAL, &watch, nullptr);
}

/// Ends the process at the first failure, which is enough; the rest of the test would only take time.
class EndAtFailure : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (result.failed()) _exit(1);
  }
};

bool passes(const std::string& name) {
  testing::GTEST_FLAG(filter) = name;
  return RUN_ALL_TESTS() == 0 && testing::UnitTest::GetInstance()->test_to_run_count() == 1;
}

/// Runs `body` in its own process; returns its status.
template <class Body>
int forked(const Body& body, rusage* usage) {
  const pid_t child = fork();
  if (child == 0) {
    const int null = open("/dev/null", O_RDWR);
    dup2(null, 0);
    dup2(null, 1);
    dup2(null, 2);
    const rlimit memory{rlim_t{3} << 30, rlim_t{3} << 30};
    setrlimit(RLIMIT_AS, &memory);
    const rlimit core{0, 0};
    setrlimit(RLIMIT_CORE, &core);
    _exit(body());
  }
  int status = 0;
  while (wait4(child, &status, 0, usage) < 0 && errno == EINTR) {
  }
  return status;
}

double milliseconds(const rusage& usage) {
  const auto of = [](const timeval& t) {
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
  };
  return of(usage.ru_utime) + of(usage.ru_stime);
}

}  // namespace

int main(int argc, char** argv) {
  setenv("RC_PARAMS", "seed=20250915 max_success=30", 0);
  testing::InitGoogleTest(&argc, argv);
  if (argc != 3) return 64;
  register_files(argv[1]);
  const std::vector<std::string> names = test_names();
  testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
  delete listeners.Release(listeners.default_result_printer());
  listeners.Append(new EndAtFailure);
  if (std::string(argv[2]) == "--reach") {
    for (std::size_t t = 0; t < names.size(); ++t) {
      std::memset(shared->reached, 0, sizeof shared->reached);
      rusage usage{};
      const int status = forked([&] { return passes(names[t]) ? 0 : 1; }, &usage);
      std::printf("%zu\t%.1f\t%s\t%s\t", t, milliseconds(usage), status == 0 ? "passes" : "fails", names[t].c_str());
      for (unsigned m = 1; m < MUTANT_COUNT; ++m) {
        if (shared->reached[m] != 0) std::printf("%u ", m);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
    return 0;
  }
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream in(line);
    unsigned number = 0;
    in >> number;
    std::vector<std::pair<int, double>> tests;
    for (std::string test; in >> test;) tests.emplace_back(std::stoi(test), std::stod(test.substr(test.find(':') + 1)));
    rusage usage{};
    const int status = forked(
        [&] {
          mutant::active = number;
          for (const auto& [test, time] : tests) {
            shared->test = test;
            limit_time(10 * time + 1000);
            if (!passes(names[static_cast<std::size_t>(test)])) return 1;
          }
          return 0;
        },
        &usage);
    const char* how = "survived";
    if (WIFEXITED(status) && WEXITSTATUS(status) == 1) {
      how = "failed";
    } else if (WIFSIGNALED(status)) {
      how = WTERMSIG(status) == SIGPROF ? "hung" : "crashed";
    } else if (status != 0) {
      how = "crashed";
    }
    std::printf("%u\t%s\t%s\t%.0f\n", number, how,
                std::strcmp(how, "survived") == 0 ? "" : names[static_cast<std::size_t>(shared->test)].c_str(),
                milliseconds(usage));
    std::fflush(stdout);
  }
  return 0;
}
