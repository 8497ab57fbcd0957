#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "certify/file/file.h"

/// What the reader accepts says what is written, value by value: files of every kind, one value changed at a time, are
/// read, written again, and compared by another JSON library.
namespace epsnet::certify::reader_values_test {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

// Nothing in these files is true, but all of it is well-formed.

Json tiles() {
  return Json::parse(R"({"kind": "tiles", "about": "two tiles",
      "tiles": [[["0", "0"], ["1/2", "0"], ["0", "-2/3"]],
                [["1", "2"], ["3", "4"], ["5", "6"], ["7", "8"], ["9", "10"]]],
      "gluing": [[0, 0, 1, 0], [0, 1, 0, 2], [1, 1, 1, 3], [1, 2, 1, 4]]})");
}

Json regular() { return Json::parse(R"({"kind": "regular", "genus": 2, "about": "an octagon"})"); }

Json surface_file(const Json& surface) { return {{"format", "epsnet-surface"}, {"version", 1}, {"surface", surface}}; }

Json net() {
  Json result = Json::parse(R"({"format": "epsnet-net", "version": 1, "epsilon": "1.5",
      "charts": [[0, "0", "0"], [1, "1/2", "-1/3"], [0, "3/5", "1/7"]],
      "labels": [[1, 0, [3]], [0, 1, [0]], [2, 0, [1]], [2, 1, [1, 0]], [1, 1, [7, 5, 4]]],
      "vertices": [[0, 0.25, -0.5], [1, 0.125, 0], [2, -0.75, 0.5], [0, 0.0625, 0.75]],
      "triangles": [[0, 1, 2, 3, 4, 5, 1, 3], [1, 0, 2, 0, 1, 2, 2, 4], [0, 3, 3, 9, 10, 11, 0, 0],
                    [3, 0, 0, 6, 7, 8, 0, 0]],
      "collars": [{"core": [0, 3], "length": [0.5, 1], "vertices": [0, 2], "triangles": [0, 1]},
                  {"core": [], "length": [0, 0.25], "vertices": [3, 1], "triangles": [3, 2]}]})");
  result["surface"] = tiles();
  return result;
}

Json regular_net() {
  Json result = Json::parse(R"({"format": "epsnet-net", "version": 1, "epsilon": "1/3",
      "charts": [[0, "0", "1/2"]], "labels": [[0, 0, [7, 0, 3]]], "vertices": [[0, 0.25, -0.5]],
      "triangles": [[0, 0, 0, 1, 2, 3, 1, 0], [0, 0, 0, 4, 5, 0, 0, 1]]})");
  result["surface"] = regular();
  return result;
}

Json net_without_triangles() {
  Json result = net();
  result["triangles"] = Json::array();
  result.erase("collars");
  return result;
}

Json geodesics(const std::string& claim) {
  Json result = Json::parse(R"({"format": "epsnet-geodesics", "version": 1,
      "geodesics": [{"vertex": 0, "word": [0, 3], "length": [0.5, 0.75], "simple": true},
                    {"vertex": 1, "word": [7, 5, 4], "length": [0.625, 1], "simple": false},
                    {"vertex": 2, "word": [1], "length": [1.5, 2], "simple": true}],
      "clusters": [{"first": 0, "count": 2, "equal": false}, {"first": 2, "count": 1, "equal": true}],
      "pieces": [{"genus": 1, "boundaries": [[0, 0], [2, 1], [1, 0]]},
                 {"genus": 0, "boundaries": [[0, 1], [1, 1], [2, 0]]}], "up_to": "2.5"})");
  result["claim"] = claim;
  result["net"] = net();
  result["net"].erase("collars");
  if (claim != "spectrum") result.erase("up_to");
  if (claim != "thick-thin") result.erase("pieces");
  if (claim == "systole") {
    result.erase("clusters");
    result["geodesics"] = Json::array({result["geodesics"][0]});
  }
  return result;
}

/// A basis of 3 of 5 curves, of a net with as many vertices and triangles as a surface with 3 coordinates would have.
Json local_maximum() {
  Json result = geodesics("spectrum");
  result["claim"] = "local-maximum";
  result["net"] = Json::parse(R"({"format": "epsnet-net", "version": 1, "epsilon": "1/3",
      "charts": [[0, "0", "1/2"]], "labels": [[0, 0, [7, 0, 3]]], "vertices": [[0, 0.25, -0.5]],
      "triangles": [[0, 0, 0, 3, 4, 5, 1, 0], [0, 0, 0, 0, 1, 2, 0, 1], [0, 0, 0, 9, 10, 11, 0, 0],
                    [0, 0, 0, 6, 7, 8, 0, 0]]})");
  result["net"]["surface"] = regular();
  Json row = result["geodesics"][0];
  row["length"] = Json::array({0.625, 0.75});
  Json last = result["geodesics"][2];
  last["vertex"] = 0;
  result["geodesics"] = Json::array({row, row, row, row, row, last});
  result["clusters"] =
      Json::parse(R"([{"first": 0, "count": 5, "equal": true}, {"first": 5, "count": 1, "equal": false}])");
  result["basis"] = Json::array({0, 2, 3});
  result["weights"] = Json::array({7, 2});
  return result;
}

/// The members of the claim.
Json any_list(const std::string& claim) { return claim == "local-maximum" ? local_maximum() : geodesics(claim); }

/// A list in which nothing is.
Json empty_list(const std::string& claim) {
  Json result = geodesics(claim);
  for (const char* member : {"geodesics", "clusters", "pieces"}) {
    if (result.contains(member)) result[member] = Json::array();
  }
  return result;
}

Json distance() {
  Json result = Json::parse(R"({"format": "epsnet-distance", "version": 1, "point": [0, "1/3", "-2/5"],
      "distance": [0.5, 1.25], "paths": [[7, 0], [], [3]], "equal": true})");
  result["net"] = regular_net();
  return result;
}

Json cover(const std::string& claim) {
  Json result = Json::parse(R"({"format": "epsnet-cover", "version": 1, "value": [0.5, 1.25],
      "triangulations": [[0, 5, 3], [1], [0, 2]], "cells": [[0, 3, 1, 6, 5], [4]]})");
  result["claim"] = claim;
  result["net"] = regular_net();
  return result;
}

Json eigenvalues() {
  Json result = Json::parse(R"({"format": "epsnet-eigenvalues", "version": 1,
      "eigenvalues": [{"in": [1, 2.5], "count": 2}, {"in": [3, 4], "count": 1}], "next": 5.5, "halvings": 0,
      "side_order": [2, 0, 1, 3, 5, 4], "vertex_order": [3, 1, 0, 2],
      "at_most": [{"below": 0.5, "count": 0, "sigma": 0.75}, {"below": 5, "count": 3, "sigma": 6}],
      "at_least": [{"below": 2, "count": 1}],
      "eigenfunctions": [{"in": [1, 2], "lambda": 1.5, "radius": 1.75,
                          "functions": [[1, 0.5, -0.25, 2, 0, 0, 1, 3, 0.125, 0, 0.75, 4],
                                        [0, 0, 0.5, 0, 7, 0, 1, 0, 0, 0, 0.25, 0]]},
                         {"in": [3, 4], "lambda": 3.25, "radius": 1.625,
                          "functions": [[1, 0, 0, 2, 0, 0, 1, 0, 0.125, 0, 0.75, 4]]}]})");
  result["net"] = net();
  result["net"].erase("collars");
  return result;
}

Json sections() {
  Json result = eigenvalues();
  result["phases"] = {"1/3", "-0.25", "0", "1/7", "0.5", "-2/3", "0", "-0"};
  result["eigenfunctions"] = Json::array();
  return result;
}

Json isometries() {
  Json result = Json::parse(R"({"order": 4, "isometries": [
      {"preserves_orientation": true, "images": [[0, 3], [2], [], [1], [0, 5, 3], [1, 1]]},
      {"preserves_orientation": false, "images": [[1], [0, 4, 3], [2], [1], [], [2, 2]]}],
      "paths": [[], [0]], "pair": [[1], [0, 7, 3]], "cocycle": [4294967295, 0, 17, 5]})");
  result.update(geodesics("spectrum"));
  result.erase("claim");
  result["format"] = "epsnet-isometries";
  return result;
}

Json pants() {
  Json result = Json::parse(R"({"format": "epsnet-pants", "version": 1,
      "pants": [[[0, 3], [2]], [[7, 2, 5], []]], "cuffs": [
      {"ends": [[0, 0], [1, 0]], "across": [], "length": [0.5, 1.25], "twist": [-3.5, 0], "exp_half_length": "0"},
      {"ends": [[1, 1], [0, 2]], "across": [7, 4], "length": [2, 2], "twist": [0.25, 7], "exp_half_length": "4/3"},
      {"ends": [[1, 2], [0, 1]], "across": [1], "length": [3, 4], "twist": [-2, -1], "exp_half_length": "2"}]})");
  result["net"] = regular_net();
  return result;
}

Json comparison(const char* claim) {
  Json result = Json::parse(R"({"preserves_orientation": true, "paths": [[]], "pair": [[1], [0, 7, 3]],
      "images": [[0, 3], [2], [], [1], [0, 5, 3], [1, 1]]})");
  result["net"] = regular_net();
  result["other_net"] = net();
  result["other_net"].erase("collars");
  if (std::string_view(claim) == "different") {
    result = geodesics("spectrum");
    result["other_spectrum"] = geodesics("spectrum");
  }
  result["format"] = "epsnet-comparison";
  result["version"] = 1;
  result["claim"] = claim;
  return result;
}

Json curves() {
  Json result = Json::parse(R"({"format": "epsnet-curves", "version": 1, "curves": [
      {"vertex": 0, "word": [0, 3], "length": [0.5, 1.25], "power": 3, "self_intersections": 4, "homology": [1, -2]},
      {"vertex": 0, "word": [7], "length": [2, 2], "power": 1, "self_intersections": 0, "homology": [0, 0]},
      {"vertex": 0, "word": [], "length": [3, 4], "power": 2, "self_intersections": 17, "homology": [-7, 5]}],
      "pairs": [{"first": 0, "second": 1, "intersections": 5, "algebraic": -3},
                {"first": 0, "second": 2, "intersections": 0, "algebraic": 0},
                {"first": 1, "second": 2, "intersections": 9007199254740992, "algebraic": -9007199254740992}],
      "basis": [2, 0], "filling": [[0, 2], [], [1]]})");
  result["net"] = regular_net();
  return result;
}

std::vector<Json> files() {
  return {surface_file(tiles()),
          surface_file(regular()),
          net(),
          regular_net(),
          net_without_triangles(),
          geodesics("systole"),
          geodesics("spectrum"),
          geodesics("thick-thin"),
          local_maximum(),
          empty_list("spectrum"),
          empty_list("thick-thin"),
          distance(),
          cover("radius"),
          cover("diameter"),
          cover("embedded-disk"),
          eigenvalues(),
          sections(),
          isometries(),
          pants(),
          comparison("isometric"),
          comparison("different"),
          curves()};
}

/// What the reader understands, as JSON; null if it accepts nothing.
Json understood(const std::string& text, bool surface) {
  std::ostringstream out;
  try {
    if (surface) {
      write_file(parse_file<SurfaceDocument>(text, "test"), out);
    } else {
      write_file(parse_file<ClaimDocument>(text, "test"), out);
    }
  } catch (const MalformedError&) {
    return nullptr;
  }
  return Json::parse(out.str());
}

/// Whether the text is accepted.
bool accepted(const std::string& text, const Json& meant, bool surface) {
  const Json found = understood(text, surface);
  if (found.is_null()) return false;
  EXPECT_EQ(found, meant);
  return true;
}

bool is_surface(const Json& file) { return file["format"] == "epsnet-surface"; }

bool accepted(const Json& file, bool surface) { return accepted(file.dump(), file, surface); }

void collect(const Json& value, const Pointer& at, std::vector<Pointer>& places) {
  places.push_back(at);
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) collect(member, at / key, places);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], at / i, places);
  }
}

std::vector<Pointer> places_of(const Json& file) {
  std::vector<Pointer> places;
  collect(file, Pointer(), places);
  return places;
}

/// Calls use(file, place) for the files, each with one value changed by `changes`, which gives values for one.
void with_changes(const std::function<std::vector<Json>(const Json&)>& changes,
                  const std::function<void(const Json&, const Pointer&, bool)>& use) {
  for (const Json& file : files()) {
    for (const Pointer& place : places_of(file)) {
      for (Json& value : changes(file[place])) {
        Json changed = file;
        changed[place] = std::move(value);
        if (changed != file) use(changed, place, is_surface(file));
      }
    }
  }
}

TEST(ReaderValues, TheFilesAreWellFormed) {
  for (const Json& file : files()) EXPECT_TRUE(accepted(file, is_surface(file))) << file;
}

TEST(ReaderValues, NoValueHasAnotherType) {
  const auto kind = [](const Json& value) { return value.is_number() ? Json(0).type() : value.type(); };
  const std::vector<Json> values{nullptr, true, 1, "1", Json::array(), Json::object()};
  with_changes(
      [&](const Json& old) {
        std::vector<Json> others;
        for (const Json& value : values) {
          if (kind(value) != kind(old)) others.push_back(value);
        }
        return others;
      },
      [](const Json& file, const Pointer& place, bool surface) {
        EXPECT_FALSE(accepted(file, surface)) << place << ' ' << file[place];
      });
}

TEST(ReaderValues, NumbersAndTextsAreWhatIsWritten) {
  int count = 0;
  with_changes(
      [](const Json& old) -> std::vector<Json> {
        if (old.is_boolean()) return {!old.get<bool>()};
        if (old.is_number_integer()) {
          const auto n = old.get<std::int64_t>();
          return {n + 1, n - 1, 0, 1, 2, n + (std::int64_t{1} << 32), static_cast<double>(n) + 0.5};
        }
        if (old.is_number()) return {old.get<double>() / 4, old.get<double>() + 0x1p-20, -old.get<double>()};
        if (old.is_string()) return {"3/11", "-3/11", "0", "17", old.get<std::string>() + "x", "1/0"};
        return {};
      },
      [&](const Json& file, const Pointer&, bool surface) { count += accepted(file, surface) ? 1 : 0; });
  EXPECT_GT(count, 300);
}

TEST(ReaderValues, ArraysAreWhatIsWritten) {
  int count = 0;
  with_changes(
      [](const Json& old) -> std::vector<Json> {
        if (!old.is_array()) return {};
        std::vector<Json> changed(5, old);
        changed[0].push_back(old.empty() ? Json(0) : old.back());
        if (!old.empty()) {
          changed[1].erase(old.size() - 1);
          changed[2].erase(0);
          changed[3].insert(changed[3].begin(), old.front());
          std::swap(changed[4].front(), changed[4].back());
        }
        return changed;
      },
      [&](const Json& file, const Pointer&, bool surface) { count += accepted(file, surface) ? 1 : 0; });
  EXPECT_GT(count, 100);
}

TEST(ReaderValues, EveryMemberIsThereOnce) {
  for (const Json& file : files()) {
    for (const Pointer& place : places_of(file)) {
      if (!file[place].is_object()) continue;
      Json more = file;
      more[place]["another"] = 1;
      EXPECT_FALSE(accepted(more, is_surface(file))) << place;
      for (const auto& [key, value] : file[place].items()) {
        Json less = file;
        less[place].erase(key);
        EXPECT_EQ(accepted(less, is_surface(file)), key == "about" || key == "collars" || key == "phases")
            << place << ' ' << key;
        // Twice: under the name that comes last, which is then made the same.
        Json twice = file;
        twice[place]["~"] = value;
        std::string text = twice.dump();
        text.replace(text.find("\"~\""), 3, Json(key).dump());
        EXPECT_FALSE(accepted(text, file, is_surface(file))) << place << ' ' << key;
      }
    }
  }
}

std::string complaint(const Json& file) {
  try {
    static_cast<void>(parse_file<ClaimDocument>(file.dump(), "test"));
  } catch (const MalformedError& error) {
    return error.what();
  }
  return "";
}

TEST(ReaderValues, MembersThatAClaimHasOrHasNotAreNamed) {
  Json file = geodesics("spectrum");
  file.erase("up_to");
  EXPECT_EQ(complaint(file), "test: geodesics file: missing member \"up_to\" for this claim");
  file = geodesics("thick-thin");
  file.erase("pieces");
  EXPECT_EQ(complaint(file), "test: geodesics file: missing member \"pieces\" for this claim");
  file.erase("clusters");
  EXPECT_EQ(complaint(file), "test: geodesics file: missing member \"clusters\" for this claim");
  file = geodesics("systole");
  file["clusters"] = Json::array();
  EXPECT_EQ(complaint(file), "test: geodesics file: unknown member \"clusters\" for this claim");
}

/// A member that one kind of surface or claim has is none of another.
TEST(ReaderValues, MembersOfAnotherKindAreRefused) {
  const auto expect_refused = [](Json file, const Pointer& place, const Json& value) {
    file[place] = value;
    EXPECT_FALSE(accepted(file, is_surface(file))) << place;
  };
  for (const Json& member : {tiles()["tiles"], Json::array()}) {
    expect_refused(surface_file(regular()), Pointer("/surface/tiles"), member);
  }
  for (const Json& member : {tiles()["gluing"], Json::array()}) {
    expect_refused(surface_file(regular()), Pointer("/surface/gluing"), member);
  }
  expect_refused(surface_file(tiles()), Pointer("/surface/genus"), 2);
  expect_refused(surface_file(tiles()), Pointer("/surface/genus"), 0);
  for (const std::string claim : {"systole", "spectrum", "thick-thin", "local-maximum"}) {
    const Json file = any_list(claim);
    for (const char* member : {"up_to", "clusters", "pieces", "basis", "weights"}) {
      if (file.contains(member)) continue;
      expect_refused(file, Pointer("/") / member, Json::array());
      expect_refused(file, Pointer("/") / member, "");
      const Json has_it = geodesics("thick-thin").contains(member) ? geodesics("thick-thin") : local_maximum();
      expect_refused(file, Pointer("/") / member, has_it[member]);
    }
    for (const std::string other :
         {"systole", "spectrum", "thick-thin", "local-maximum", "", "Systole", "thick_thin"}) {
      if (other != claim) expect_refused(file, Pointer("/claim"), other);
    }
  }
  for (const std::string other : {"", "Radius", "eccentricity"}) {
    expect_refused(cover("radius"), Pointer("/claim"), other);
  }
}

}  // namespace
}  // namespace epsnet::certify::reader_values_test
