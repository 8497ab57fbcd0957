#!/usr/bin/env python3
"""Runs the tests against the mutants of the checkers (mutate.py) until one fails.

run.py FOLDER all       [OPTIONS]   all mutants that have no result yet, then the report
run.py FOLDER again     [OPTIONS]   those that survived, with the current tests, then the report
run.py FOLDER report    [OPTIONS]   every survivor: number, place, change; and counts by room
run.py FOLDER mutant NUMBER         runs all tests that reach this mutant, and names those that see it
run.py FOLDER fresh                 forgets all results

FOLDER is tests/assurance/checker_mutants in a build folder. Options: --only REGEX (file:function), --runner NAME
(certify, nets), --seconds S (total time of the tests of one mutant, measured without it; default 8), --jobs N (default 2),
--tests REGEX.

Results are kept in FOLDER/results.json by the text of the change, not by its number, so that they stay valid when other
parts of the sources change; `reach` is found again whenever a runner is newer.
"""
import argparse
import collections
import importlib.util
import json
import os
import re
import subprocess
import sys
import threading

HERE = os.path.dirname(os.path.abspath(__file__))
RUNNERS = ("certify", "nets")
OUTCOMES = {"failed": "a test fails", "crashed": "crash", "hung": "hang", "survived": "survive", "not run": "not run yet"}


def key_of(m):
    return "|".join((m["file"], m["function"], m["line"], m["from"], m["to"], str(m["nth"])))


def in_turn(tests, reached):
    """Orders tests by the number of mutants that they reach, to within a factor of two: those that reach few are about this
    place. Among equals come the quickest of each suite, then the second of each, and so on, as there are many similar tests
    of files, and if one of them does not see a mutant, few others do."""
    rank = collections.Counter()
    order = []
    for test in sorted(tests):
        suite = test[2].split(".")[0]
        rank[suite] += 1
        order.append((reached[test[1]].bit_length(), rank[suite], test))
    return [test for _, _, test in sorted(order)]


class Folder:
    def __init__(self, path):
        self.path = path
        with open(os.path.join(path, "tree", "mutants.json"), encoding="utf-8") as file:
            self.mutants = json.load(file)
        self.by_id = {m["id"]: m for m in self.mutants}
        self.lock = threading.Lock()
        self.results = {}
        if os.path.exists(self.at("results.json")):
            with open(self.at("results.json"), encoding="utf-8") as file:
                self.results = json.load(file)

    def at(self, name):
        return os.path.join(self.path, name)

    def save(self):
        with open(self.at("results.json.new"), "w", encoding="utf-8") as file:
            json.dump(self.results, file, ensure_ascii=False, indent=0)
        os.replace(self.at("results.json.new"), self.at("results.json"))

    def write_files(self):
        script = os.path.join(os.path.dirname(HERE), "forgeries.py")
        table = self.at("files/files.tsv")
        if os.path.exists(table) and os.path.getmtime(table) > os.path.getmtime(script):
            return
        os.makedirs(self.at("files"), exist_ok=True)
        sys.path.insert(0, os.path.dirname(script))
        spec = importlib.util.spec_from_file_location("forgeries", script)
        forgeries = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(forgeries)
        lines = []
        for name, entry in forgeries.entries.items():
            with open(self.at(f"files/{name}.json"), "wb") as file:
                file.write(forgeries.contents(name))
            lines.append("\t".join((name, entry.certify, entry.exact, ",".join(sorted(entry.also)), entry.says)))
        with open(table, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")

    def reach(self, runner):
        """Returns {mutant: [(milliseconds, test number, name)]} for the tests that pass, in the order in which they run."""
        program, table = self.at("mutants_" + runner), self.at(f"reach-{runner}.tsv")
        if not os.path.exists(table) or os.path.getmtime(table) < os.path.getmtime(program):
            print(f"which mutants the tests of mutants_{runner} reach", flush=True)
            built = os.path.getmtime(program)  # If the program is rebuilt while it runs, the table is outdated.
            with open(table + ".new", "w", encoding="utf-8") as file:
                subprocess.run(["nice", program, self.at("files"), "--reach"], stdout=file, check=True)
            os.utime(table + ".new", (built, built))
            os.replace(table + ".new", table)
        result = collections.defaultdict(list)
        count = {}
        with open(table, encoding="utf-8") as file:
            for line in file:
                number, time, passes, name, reached = line.rstrip("\n").split("\t")
                if passes != "passes":
                    print(f"without a mutant {name} fails", flush=True)
                    continue
                mutants = [int(m) for m in reached.split()]
                count[int(number)] = len(mutants)
                for m in mutants:
                    result[m].append((float(time), int(number), name))
        return {m: in_turn(tests, count) for m, tests in result.items()}


class Runner:
    def __init__(self, folder, name):
        self.process = subprocess.Popen(["nice", folder.at("mutants_" + name), folder.at("files"), "--run"],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def run(self, mutant, tests):
        self.process.stdin.write(f"{mutant} " + " ".join(f"{t[1]}:{t[0]}" for t in tests) + "\n")
        self.process.stdin.flush()
        return self.process.stdout.readline().rstrip("\n").split("\t")


def run(folder, runner, wanted, reach, options):
    """Returns the mutants that survive."""
    killers = collections.defaultdict(list)  # By function: the tests that killed mutants there most recently.
    kills = collections.Counter()  # By file and test.
    for m in folder.mutants:
        kills[m["file"], folder.results.get(key_of(m), {}).get("test")] += 1
    pending = collections.deque(wanted)
    survivors, done = [], [0]

    def work():
        process = Runner(folder, runner)
        while True:
            with folder.lock:
                if not pending:
                    break
                m = pending.popleft()
                recent = killers[m["file"], m["function"]][-4:]
            tests = [t for t in reach.get(m["id"], []) if re.search(options.tests, t[2])]
            first = [t for t in tests if t[2] in recent]
            first += sorted((t for t in tests if t not in first and kills[m["file"], t[2]] > 0),
                            key=lambda t: t[0] / kills[m["file"], t[2]])
            order, spent = [], 0
            for t in first + [t for t in tests if t not in first]:
                if spent + t[0] > 1000 * options.seconds:
                    continue
                spent += t[0]
                order.append(t)
            answer = process.run(m["id"], order) if order else [str(m["id"]), "survived", "", "0"]
            with folder.lock:
                done[0] += 1
                entry = folder.results.setdefault(key_of(m), {})
                entry["how"], entry["test"] = answer[1], answer[2]
                entry["tests"] = len(order)
                entry["reached"] = entry.get("reached", False) or bool(tests)
                if answer[1] == "survived":
                    survivors.append(m)
                else:
                    kills[m["file"], answer[2]] += 1
                    recent = killers[m["file"], m["function"]]
                    if answer[2] in recent:
                        recent.remove(answer[2])
                    recent.append(answer[2])
                if done[0] % 50 == 0:
                    print(f"{runner}: {done[0]} of {len(wanted)}, {len(survivors)} survive", flush=True)
                    folder.save()
    threads = [threading.Thread(target=work) for _ in range(options.jobs)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    folder.save()
    return survivors


def select(folder, options):
    return [m for m in folder.mutants if re.search(options.only, m["file"] + ":" + m["function"])]


def room_of(path):
    parts = path.split("/")
    return "certify" if len(parts) == 2 else "/".join(parts[:2])


def report(folder, options):
    rooms = collections.defaultdict(collections.Counter)
    for m in select(folder, options):
        result = folder.results.get(key_of(m), {"how": "not run"})
        rooms[room_of(m["file"])][result["how"]] += 1
        if result["how"] == "survived":
            print(f"{m['id']} {m['file']}:{m['line_number']} {m['function']} [{m['kind']}]{'' if result['reached'] else ' NOT REACHED'}"
                  f" {m['from'][:110]}  =>  {m['to'][:110]}\n      {m['line'][:150]}")
    counts = [(room, rooms[room]) for room in sorted(rooms)] + [("all", sum(rooms.values(), collections.Counter()))]
    print("| room | mutants | " + " | ".join(OUTCOMES.values()) + " |\n| --- |" + " --: |" * (len(OUTCOMES) + 1))
    for room, count in counts:
        print(f"| {room} | {sum(count.values())} | " + " | ".join(str(count[how]) for how in OUTCOMES) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("command", choices=("all", "again", "report", "mutant", "fresh"))
    parser.add_argument("number", nargs="?", type=int)
    parser.add_argument("--only", default="")
    parser.add_argument("--runner", default=None)
    parser.add_argument("--seconds", type=float, default=8)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tests", default="")
    options = parser.parse_args()
    folder = Folder(options.folder)
    if options.command == "fresh":
        folder.results = {}
        folder.save()
        return
    runners = [options.runner] if options.runner else list(RUNNERS)
    if options.command == "mutant":
        folder.write_files()
        m = folder.by_id[options.number]
        print(json.dumps(m, indent=1, ensure_ascii=False))
        for name in runners:
            process = Runner(folder, name)
            for t in folder.reach(name).get(options.number, []):
                if re.search(options.tests, t[2]):
                    print(f"{t[0]:8.1f} ms  {process.run(options.number, [t])[1]:9} {t[2]}", flush=True)
        return
    if options.command in ("all", "again"):
        folder.write_files()
        done = {"all": None, "again": "survived"}[options.command]
        wanted = [m for m in select(folder, options) if folder.results.get(key_of(m), {}).get("how") == done]
        for name in runners:
            wanted = run(folder, name, wanted, folder.reach(name), options)
    report(folder, options)


if __name__ == "__main__":
    main()
