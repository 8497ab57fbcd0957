#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>
#include <variant>

#include "certify/base/error.h"
#include "certify/check.h"
#include "certify/claims.h"
#include "certify/claims/net/claim.h"
#include "certify/file/file.h"
#include "certify/net/structure.h"
#include "certify/verdict/verification.h"

/// Nothing is VERIFIED unless every rule that a claim declares was reported, once, and is.
namespace epsnet::certify::rule_book_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::StartsWith;

RuleReport verified(const std::string& rule) { return {rule, Verdict::verified, "it holds"}; }
RuleReport refuted(const std::string& rule) { return {rule, Verdict::refuted, "it fails"}; }
RuleReport undecided(const std::string& rule) { return {rule, Verdict::undecided, "it is open"}; }

/// The verdict line about a claim with the rules a, b and c after these reports.
std::string conclusion(const std::vector<RuleReport>& reports) {
  RuleBook book({"a", "b", "c"});
  for (const RuleReport& report : reports) book.report(report);
  Certificate certificate;
  // What was there before does not count.
  certificate.verdict = Verdict::verified;
  book.conclude(certificate);
  EXPECT_EQ(certificate.rules.size(), reports.size());
  return verdict_line(certificate);
}

/// What the program says of itself when this is reported after `before`.
std::string fault(const std::vector<RuleReport>& before, const RuleReport& last) {
  RuleBook book({"a", "b", "c"});
  for (const RuleReport& report : before) book.report(report);
  try {
    book.report(last);
  } catch (const Fault& fault) {
    EXPECT_EQ(book.reports().size(), before.size());
    return fault.what();
  }
  return "none";
}

TEST(RuleBook, EveryRuleThatIsDeclaredHasToBeVerified) {
  EXPECT_EQ(conclusion({verified("a"), verified("b"), verified("c")}), "VERIFIED");
  EXPECT_EQ(conclusion({}), "UNDECIDED: a: the rule was not asked");
  EXPECT_EQ(conclusion({verified("a")}), "UNDECIDED: b: the rule was not asked");
  EXPECT_EQ(conclusion({verified("a"), verified("b")}), "UNDECIDED: c: the rule was not asked");
}

TEST(RuleBook, TheFirstRefutedRuleDecidesThenTheFirstOpenOne) {
  EXPECT_EQ(conclusion({refuted("a")}), "REFUTED: a: it fails");
  EXPECT_EQ(conclusion({undecided("a")}), "UNDECIDED: a: it is open");
  EXPECT_EQ(conclusion({undecided("a"), refuted("b"), refuted("c")}), "REFUTED: b: it fails");
  EXPECT_EQ(conclusion({verified("a"), undecided("b"), refuted("c")}), "REFUTED: c: it fails");
  EXPECT_EQ(conclusion({verified("a"), undecided("b"), undecided("c")}), "UNDECIDED: b: it is open");
  EXPECT_EQ(conclusion({verified("a"), verified("b"), undecided("c")}), "UNDECIDED: c: it is open");
}

TEST(RuleBook, AReportThatIsNotTheNextOneIsAFaultOfTheProgram) {
  const std::string begin = "a fault of this program: rule ";
  EXPECT_EQ(fault({}, verified("b")), begin + "b was reported, expected a");
  EXPECT_EQ(fault({verified("a")}, verified("a")), begin + "a was reported, expected b");
  EXPECT_EQ(fault({verified("a"), verified("b")}, verified("a")), begin + "a was reported, expected c");
  EXPECT_EQ(fault({verified("a")}, verified("d")), begin + "d was reported, expected b");
  EXPECT_EQ(fault({verified("a")}, verified("")), begin + " was reported, expected b");
  EXPECT_EQ(fault({verified("a"), verified("b"), verified("c")}, verified("c")),
            begin + "c was reported, expected no more");
  EXPECT_THAT(fault({}, {"a", Verdict::malformed, ""}), HasSubstr("a fault of this program: "));
}

TEST(RuleBook, AClaimDeclaresRulesEachOnce) {
  EXPECT_THROW(RuleBook({}), Fault);
  EXPECT_THROW(RuleBook({"a", "b", "a"}), Fault);
}

TEST(RuleBook, VerifiedSoFarIsAboutWhatWasReported) {
  RuleBook book({"a", "b", "c"});
  EXPECT_TRUE(book.verified_so_far());
  book.report(verified("a"));
  EXPECT_TRUE(book.verified_so_far());
  book.report(undecided("b"));
  book.report(verified("c"));
  EXPECT_FALSE(book.verified_so_far());
}

TEST(OpenRules, AreOpenUntilTheyAreDecidedAndSayWhyTheyAreNot) {
  OpenRules rules({"a", "b", "c", "d"});
  rules.report(verified("b"));
  rules.report(refuted("c"));
  // Nothing is known of a rule that is not one of them.
  const auto known = [&](const char* rule, Verdict verdict, bool open) {
    EXPECT_EQ(rules.verdict(rule), verdict) << rule;
    EXPECT_EQ(rules.open(rule), open) << rule;
  };
  known("a", Verdict::undecided, true);
  known("b", Verdict::verified, false);
  known("c", Verdict::refuted, false);
  known("e", Verdict::undecided, false);
  EXPECT_THROW(rules.report(verified("e")), Fault);
  for (const char* rule : {"a", "b", "c", "e"}) rules.doubt(rule, "doubt");
  const auto said = [](OpenRules some) {
    Verification run({.threads = 1}, 1, {"a", "b", "c", "d"}, "a claim");
    some.conclude(run);
    std::vector<std::string> result;
    for (const RuleReport& report : run.rules().reports()) result.push_back(to_string(report));
    return result;
  };
  EXPECT_THAT(said(rules), ElementsAre("a: UNDECIDED: doubt", "b: VERIFIED: it holds", "c: REFUTED: it fails",
                                       "d: UNDECIDED: not decided"));
  rules.give_up("no work left");
  EXPECT_THAT(said(rules), ElementsAre("a: UNDECIDED: no work left", "b: VERIFIED: it holds", "c: REFUTED: it fails",
                                       "d: UNDECIDED: no work left"));
  // A report replaces the one before.
  rules.report(verified("a"));
  known("a", Verdict::verified, false);
}

// Claims about a net that is one.

NetDocument net() {
  return read_file<NetDocument>(std::string(EPSNET_TEST_DATA) + "/certify/verified/octagon-9-vertices.json");
}

/// The verdict line about a claim with the further rules a and b that are asked like this.
std::string line_of(const NetDocument& document, const std::function<void(Verification&)>& ask,
                    const CheckOptions& options = {.threads = 1}) {
  const Claim claim{document, "a claim", {"a", "b"}, [&](Verification& run, const Crossings&) { ask(run); }};
  const Certificate certificate = verify(claim, 1, options);
  EXPECT_EQ(certificate.claim, "a claim");
  return verdict_line(certificate);
}

TEST(Verification, AClaimWhoseRulesAreNotReportedIsNotVerified) {
  const NetDocument document = net();
  EXPECT_EQ(line_of(document, [](Verification&) {}), "UNDECIDED: a: the rule was not asked");
  EXPECT_EQ(line_of(document, [](Verification& run) { run.report(verified("a")); }),
            "UNDECIDED: b: the rule was not asked");
  EXPECT_EQ(line_of(document,
                    [](Verification& run) {
                      run.report(verified("a"));
                      run.report(verified("b"));
                    }),
            "VERIFIED");
  EXPECT_THROW((void)line_of(document, [](Verification& run) { run.report(verified("b")); }), Fault);
  EXPECT_THROW((void)line_of(document, [](Verification& run) { run.report(verified("packing")); }), Fault);
}

TEST(Verification, ARuleThatRunsOutOfWorkIsUndecided) {
  const NetDocument document = net();
  const auto spend = [](Verification& run) { run.budget().spend(std::uint64_t{1} << 62); };
  EXPECT_EQ(line_of(document, spend), "UNDECIDED: a: " + std::string(BudgetSpent().what()));
  EXPECT_EQ(line_of(document,
                    [&](Verification& run) {
                      run.report(verified("a"));
                      spend(run);
                    }),
            "UNDECIDED: b: " + std::string(BudgetSpent().what()));
  // Work after the last rule would leave a verdict that nothing supports.
  EXPECT_THROW((void)line_of(document,
                             [&](Verification& run) {
                               run.report(verified("a"));
                               run.report(verified("b"));
                               spend(run);
                             }),
               Fault);
}

TEST(Verification, AClaimIsAskedAboutNetsThatAreVerifiedAndNotTooLarge) {
  const auto never = [](Verification&) { ADD_FAILURE() << "asked"; };
  NetDocument document = net();
  CheckOptions options{.threads = 1, .max_triangles = document.triangles.size() - 1};
  EXPECT_THAT(line_of(document, never, options), HasSubstr("UNDECIDED: a: the net has more triangles than the limit"));
  document.epsilon = "0.1";
  EXPECT_THAT(line_of(document, never), HasSubstr("REFUTED: covering"));
  document = net();
  document.triangles[0].opposite[0] = 0;
  EXPECT_THAT(line_of(document, never), HasSubstr("REFUTED: map"));
}

// The rules that format.md names.

/// A section of docs/format.md, from a line to the next of the same kind.
std::string section(const std::string& heading) {
  std::ifstream in(std::string(EPSNET_TEST_DATA) + "/../../docs/format.md");
  std::stringstream text;
  text << in.rdbuf();
  const std::string all = text.str();
  const std::size_t begin = all.find("\n" + heading + "\n");
  EXPECT_NE(begin, std::string::npos) << heading;
  return all.substr(begin, all.find("\n## ", begin + 1) - begin);
}

/// What is in the parentheses of the pattern, in each place where it fits.
std::vector<std::string> all_of(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> result;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) result.push_back((*i)[1]);
  return result;
}

/// The words in quotes in the sentence that says what is asked after the rules of the net.
std::vector<std::string> rules_named_in(const std::string& heading) {
  const std::string text = section(heading);
  const std::size_t begin = text.find("\nThen ");
  EXPECT_NE(begin, std::string::npos) << heading;
  return all_of(text.substr(begin, text.find(".\n", begin) - begin), "`([a-z]+)`");
}

/// The rules after those of the net.
template <class Document>
std::vector<std::string> own_rule_names(const Document& document) {
  const RuleNames net_rules = with_net_rules(document.net, {});
  const RuleNames all = with_net_rules(document.net, own_rules(document));
  EXPECT_TRUE(all.size() > net_rules.size() && std::equal(net_rules.begin(), net_rules.end(), all.begin()));
  return {all.begin() + static_cast<std::ptrdiff_t>(net_rules.size()), all.end()};
}

TEST(Claims, HaveARowASectionOfTheFormatAndOneOfTheProof) {
  std::stringstream proof;
  for (const auto& part : std::filesystem::directory_iterator(std::string(EPSNET_TEST_DATA) + "/../../docs/proof")) {
    proof << std::ifstream(part.path()).rdbuf();
  }
  for (const ClaimKind& kind : kClaimKinds) {
    std::string title(kind.name);
    title[0] = static_cast<char>(std::toupper(title[0]));
    EXPECT_THAT(section("## " + title + " file"), HasSubstr("\"format\": \"" + std::string(kind.format) + "\""));
    EXPECT_THAT(std::string(kind.says), StartsWith("A" + kind.file().substr(1) + " claims "));
    EXPECT_THAT(proof.str(), HasSubstr("\n## " + std::to_string(kind.section) + ". "));
  }
}

/// The first file of the test data that begins like this.
std::string file_that_begins_with(const std::string& text) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(EPSNET_TEST_DATA)) {
    if (entry.path().extension() != ".json" || entry.path().string().find("malformed") != std::string::npos) continue;
    std::string beginning(text.size(), ' ');
    std::ifstream(entry.path()).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    if (beginning == text) found.push_back(entry.path().string());
  }
  std::sort(found.begin(), found.end());
  return found.empty() ? "no file of the test data begins with " + text : found.front();
}

TEST(Claims, OfAFileIsTheRowWithItsFormat) {
  for (const ClaimKind& kind : kClaimKinds) {
    const std::string path = file_that_begins_with("{\"format\":\"" + std::string(kind.format) + "\"");
    EXPECT_EQ(kind_of(read_file<ClaimDocument>(path)).name, kind.name) << path;
  }
}

TEST(Rules, OfANetAreThoseOfTheDocument) {
  const std::string text = section("## Net file");
  const std::vector<std::string> pseudo = all_of(text, "\n\\* `([a-z]+)`(?:, for pseudo nets)?:");
  const std::vector<std::string> only = all_of(text, "\n\\* `([a-z]+)`, for pseudo nets:");
  ASSERT_EQ(pseudo.size(), 9U);
  std::vector<std::string> usual = pseudo;
  std::erase_if(usual,
                [&](const std::string& rule) { return std::find(only.begin(), only.end(), rule) != only.end(); });
  NetDocument document;
  EXPECT_THAT(with_net_rules(document, {}), ElementsAreArray(usual));
  document.collars.emplace();
  EXPECT_THAT(with_net_rules(document, {}), ElementsAreArray(pseudo));
}

TEST(Rules, OfGeodesicsAreThoseOfTheDocument) {
  GeodesicsDocument document;
  const std::vector<std::string> named = rules_named_in("## Geodesics file");
  document.claim = GeodesicsDocument::Claim::thick_thin;
  EXPECT_EQ(own_rule_names(document), std::vector<std::string>(named.begin(), named.end() - 1));
  document.claim = GeodesicsDocument::Claim::spectrum;
  EXPECT_EQ(own_rule_names(document), std::vector<std::string>(named.begin(), named.end() - 2));
  document.claim = GeodesicsDocument::Claim::local_maximum;
  EXPECT_THAT(own_rule_names(document), ElementsAre("geodesics", "distinct", "simple", "equal", "complete", "maximal"));
  EXPECT_EQ(named.back(), "maximal");
  document.claim = GeodesicsDocument::Claim::systole;
  EXPECT_THAT(own_rule_names(document), ElementsAre("geodesics", "simple", "complete"));
}

/// The documents of a kind, one for each claim that it can make.
template <class Document>
std::vector<Document> one_for_each_claim() {
  if constexpr (std::is_same_v<Document, ComparisonDocument>) {
    std::vector<Document> documents(2);
    documents[1].relation = ComparisonDocument::Relation::different;
    return documents;
  } else if constexpr (std::is_same_v<Document, EigenvaluesDocument>) {
    std::vector<Document> documents(3);
    documents[1].phases = documents[2].phases = {"0"};
    documents[2].box.emplace();
    return documents;
  } else if constexpr (requires(Document document) { document.claim; }) {
    std::vector<Document> documents(Fields<typename Document::Claim>::kNames.size());
    for (std::size_t i = 0; i < documents.size(); ++i) {
      documents[i].claim = static_cast<typename Document::Claim>(i);
    }
    if constexpr (requires(Document document) { document.symmetry; }) {
      documents.insert(documents.end(), documents.begin(), documents.end());
      for (std::size_t i = 0; i < documents.size() / 2; ++i) documents[i].symmetry.emplace();
    }
    return documents;
  } else {
    return std::vector<Document>(1);
  }
}

/// Each rule that is named belongs to some claim, and no other rule to any; the order is the same.
template <class Document>
void expect_rules_of_the_document() {
  if constexpr (!std::is_same_v<Document, NetDocument>) {
    std::string title(kind_of(Document{}).name);
    title[0] = static_cast<char>(std::toupper(title[0]));
    const std::vector<std::string> named = rules_named_in("## " + title + " file");
    std::vector<std::string> found;
    for (const Document& document : one_for_each_claim<Document>()) {
      std::vector<std::string> left = named;
      const std::vector<std::string> own = own_rule_names(document);
      std::erase_if(left,
                    [&](const std::string& rule) { return std::find(own.begin(), own.end(), rule) == own.end(); });
      EXPECT_EQ(left, own) << title;
      found.insert(found.end(), own.begin(), own.end());
    }
    for (const std::string& rule : named) EXPECT_THAT(found, Contains(rule)) << title;
  }
}

TEST(Rules, OfEachClaimAreThoseOfTheDocument) {
  []<class... Documents>(const std::variant<Documents...>& /*list*/) {
    (expect_rules_of_the_document<Documents>(), ...);
  }(ClaimDocument());
}

TEST(Rules, OfBoundsAreThoseOfTheDocument) {
  const std::vector<std::string> named = rules_named_in("## Bound file");
  ASSERT_THAT(named, ElementsAre("lower", "upper", "triangulations", "isometries", "domain", "cells"));
  BoundDocument document;
  for (const auto claim : {BoundDocument::Claim::diameter, BoundDocument::Claim::embedded_disk}) {
    document.claim = claim;
    EXPECT_EQ(own_rule_names(document), (std::vector{named[0], named[2], named[5]}));
  }
  document.claim = BoundDocument::Claim::radius;
  EXPECT_EQ(own_rule_names(document), (std::vector{named[1], named[2], named[5]}));
  document.symmetry.emplace();
  EXPECT_EQ(own_rule_names(document), (std::vector{named[1], named[2], named[3], named[4], named[5]}));
}

}  // namespace
}  // namespace epsnet::certify::rule_book_test
