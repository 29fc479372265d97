# SPDX-License-Identifier: GPL-3.0-or-later
"""What is to be run for the tables: the plan of plan.toml and costs.csv as shards, each one process."""
import csv
import dataclasses
import fnmatch
import hashlib
import itertools
import pathlib
import re
import subprocess
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
CLIPS = HERE.parent.parent / "bench" / "clips"  # truth of recordings that bring none


class Failure(Exception):
    """One sentence for the user."""


@dataclasses.dataclass
class Catalog:
    """What the program has."""

    scenarios: list  # of the suite, in its order
    methods: list
    grades: list
    people: list  # scenarios with people, as "people-crossing"
    first_seed: int  # of the reporting block
    last_seed: int
    validation: tuple = (0, 0)  # first and last seed of the validation block
    experiments: tuple = ()  # names of `dewpoint-cli experiment`
    skipped: list = dataclasses.field(default_factory=list)  # sentences about recordings that are not there


@dataclasses.dataclass
class Shard:
    """One process that can be done again from where it was."""

    name: str
    command: list  # arguments of dewpoint-cli; its folder is shards/<name>
    kind: str  # "suite", "people", "convergence", "starts", the name of a figure, "fingerprint", a benchmark
    cost: float = 0.0  # seconds of one core
    seeds: tuple = ()  # first and count
    alone: bool = False  # nothing else may run meanwhile
    grade: str = "*"  # of people


def matches(patterns, text):
    return any(fnmatch.fnmatchcase(text, pattern) for pattern in patterns)


class Costs:
    """costs.csv: seconds of one core for one run."""

    def __init__(self, rows):
        self.rows = [(row["scenario"], row["grade"], row["what"], float(row["seconds"])) for row in rows]

    @staticmethod
    def read(file):
        lines = [line for line in file.read_text().splitlines() if line and not line.startswith("#")]
        return Costs(csv.DictReader(lines))

    def of(self, scenario, grade, what):
        for row in reversed(self.rows):
            if all(fnmatch.fnmatchcase(text, pattern) for text, pattern in zip((scenario, grade, what), row)):
                return row[3]
        raise Failure(f"costs.csv has no row for {scenario}, {grade}, {what}")

    def run(self, scenario, grade, methods):
        """Of one run of the suite."""
        return self.of(scenario, grade, "render") + sum(self.of(scenario, grade, method) for method in methods)


@dataclasses.dataclass
class Amount:
    """How many seeds a method gets in a scenario and grade."""

    scenario: str
    grade: str
    method: str
    seeds: int
    least: int
    options: tuple = ()  # further arguments


def amounts(rules, catalog, quick=None):
    """An Amount for each scenario, grade and method that a rule is for."""
    found = []
    for scenario in catalog.scenarios:
        if quick and not matches(quick["scenarios"], scenario):
            continue
        for grade in catalog.grades:
            mine = [rule for rule in rules if matches(rule["scenarios"], scenario) and matches(rule["grades"], grade)]
            unnamed = any(rule["methods"] == ["all"] for rule in mine)
            for method in ["all"] if unnamed else catalog.methods:
                rule = next((rule for rule in reversed(mine) if matches(rule["methods"], method)), None)
                if rule is not None and rule["seeds"] > 0 and not (quick and method in quick["leave_out"]):
                    seeds = min(rule["seeds"], quick["seeds"]) if quick else rule["seeds"]
                    least = rule.get("least", rule["seeds"])
                    found.append(Amount(scenario, grade, method, seeds, min(least, seeds),
                                        tuple(rule.get("options", ()))))
    return found


def blocks(found):
    """Runs that share their frames, as (scenario, grade, methods, first, end); seeds count from 0."""
    cells = {}
    for amount in found:
        cells.setdefault((amount.scenario, amount.grade), []).append(amount)
    for (scenario, grade), cell in cells.items():
        first = 0
        for end in sorted({amount.seeds for amount in cell if amount.seeds > 0}):
            methods = [amount.method for amount in cell if amount.seeds >= end]
            yield scenario, grade, methods, first, end
            first = end


def seconds(found, costs):
    return sum((end - first) * costs.run(scenario, grade, methods)
               for scenario, grade, methods, first, end in blocks(found))


def cut(found, costs, limit):
    """Takes seeds away, one by one, where a seed costs most, until all runs take at most `limit` seconds
    or nothing may be cut any more. The seconds that they take then."""
    total = seconds(found, costs)
    cells = {}
    for amount in found:
        cells.setdefault((amount.scenario, amount.grade), []).append(amount)
    own = {id(amount): costs.of(amount.scenario, amount.grade, amount.method) for amount in found}
    render = {cell: costs.of(*cell, "render") for cell in cells}

    def saving(amount):
        """Of its last seed. The frames are saved with the last method that needs them."""
        cell = (amount.scenario, amount.grade)
        shared = any(other.seeds >= amount.seeds for other in cells[cell] if other is not amount)
        return own[id(amount)] + (0.0 if shared else render[cell])

    while total > limit:
        most = max((amount for amount in found if amount.seeds > amount.least), key=saving, default=None)
        if most is None:
            break
        total -= saving(most)
        most.seeds -= 1
    return total


def suite_shards(found, costs, first_seed, shard_seconds):
    options = {(amount.scenario, amount.grade): amount.options for amount in found}
    for scenario, grade, methods, first, end in blocks(found):
        each = costs.run(scenario, grade, methods)
        step = max(1, int(shard_seconds / max(each, 1e-9)))
        tag = hashlib.sha256(",".join(methods).encode()).hexdigest()[:6]
        for begin in range(first, end, step):
            count = min(step, end - begin)
            seed = first_seed + begin
            name = f"suite-{scenario}-{grade}-{seed}-{count}-{tag}"
            named = [] if methods == ["all"] else ["--method", ",".join(methods)]
            more = [option.replace("{root}", str(HERE.parent.parent)) for option in options[scenario, grade]]
            command = ["suite", "--scenario", scenario, "--grade", grade, *named, "--first-seed", str(seed),
                       "--seeds", str(count), *more, "--part", "--out", f"shards/{name}"]
            yield Shard(name, command, "suite", count * each, (seed, count))


def people_shards(rules, catalog, costs, shard_seconds, quick=None):
    for scenario, grade in itertools.product(catalog.people, catalog.grades):
        rule = next((rule for rule in reversed(rules)
                     if matches(rule["scenarios"], scenario) and matches(rule["grades"], grade)), None)
        if rule is None or (quick and not matches(quick["people"], scenario)):
            continue
        seeds = min(rule["seeds"], quick["seeds"]) if quick else rule["seeds"]
        each = costs.of("people", grade, "run")
        step = max(1, int(shard_seconds / each))
        for clothes in ("different", "similar"):
            for begin in range(0, seeds, step):
                count = min(step, seeds - begin)
                seed = catalog.first_seed + begin
                name = f"{scenario}-{grade}-{clothes}-{seed}-{count}"
                command = ["experiment", scenario, "--grade", grade, "--clothes", clothes, "--seed", str(seed),
                           "--seeds", str(count), "--out", f"shards/{name}"]
                yield Shard(name, command, "people", count * each, (seed, count), grade=grade)


def study_shards(plan, catalog, costs, quick=None):
    study = quick or plan["study"]
    first = str(catalog.first_seed)
    for name in ("convergence", "starts"):
        runs = study[f"{name}_runs"]
        yield Shard(name, ["experiment", name, "--runs", str(runs), "--seed", first, "--out", f"shards/{name}"],
                    name, runs * costs.of(name, "-", "run"), (catalog.first_seed, runs))
    yield Shard("fingerprint", ["experiment", "fingerprint"], "fingerprint", costs.of("fingerprint", "-", "run"))
    yield Shard("bench", [], "bench", costs.of("bench", "-", "run"), alone=True)
    yield Shard("lazy-color", [], "lazy-color", costs.of("lazy-color", "-", "run"), alone=True)


def figure_shards(rules, catalog, costs, quick=None):
    """The papers' figures that the program has."""
    for rule in rules:
        name = rule["name"]
        if name not in catalog.experiments or (quick and not matches(quick["figures"], name)):
            continue
        for seed in range(catalog.first_seed, catalog.first_seed + (quick or rule)["seeds"]):
            arguments = [argument.replace("{seed}", str(seed)) for argument in rule["arguments"]]
            yield Shard(f"{name}-{seed}", ["experiment", name, *arguments, "--out", f"shards/{name}-{seed}"], name,
                        costs.of(name, "-", "run"), (seed, 1))


@dataclasses.dataclass
class Plan:
    shards: list
    amounts: list
    limit: float  # seconds on `cores` cores
    cores: int
    notes: list  # sentences

    def hours(self):
        """Estimated, on the plan's cores."""
        alone = sum(shard.cost for shard in self.shards if shard.alone)
        return ((sum(shard.cost for shard in self.shards) - alone) / self.cores + alone) / 3600.0


def on_validation_seeds(catalog, first_seed):
    """The catalog of a plan whose results may be looked at: they are not reported."""
    first, last = catalog.validation
    if not first <= first_seed <= last:
        raise Failure(f"plan.toml: first_seed {first_seed} of [quick] is no validation seed ({first} to {last})")
    return dataclasses.replace(catalog, first_seed=first_seed, last_seed=last)


def notes_of(plan, catalog, quick):
    """Sentences on what the plan asks for and the program, or this machine, does not have."""
    notes = list(catalog.skipped)
    wanted = sorted({grade for rule in plan["suite"] for grade in rule["grades"] if "*" not in grade})
    for grade in wanted:
        if grade not in catalog.grades:
            notes.append(f"grade {grade}: the program does not have it; left out")
    for rule in plan["figure"]:
        if rule["name"] not in catalog.experiments:
            notes.append(f"figure {rule['name']}: the program does not have it; left out")
    if quick:
        notes.append(f"validation seeds, from {catalog.first_seed} on: the tables stay out of the pages")
    return notes


def make_plan(plan, costs, catalog, quick=False):
    """The shards that fit into the hours of the plan, the longest first."""
    short = plan["quick"] if quick else None
    if quick:
        catalog = on_validation_seeds(catalog, short["first_seed"])
    hours = (short or plan)["hours"]
    cores = plan["cores"]
    shard_seconds = 60.0 * plan["shard_minutes"]
    notes = notes_of(plan, catalog, quick)
    others = [*people_shards(plan["people"], catalog, costs, shard_seconds, short),
              *study_shards(plan, catalog, costs, short),
              *figure_shards(plan["figure"], catalog, costs, short)]
    found = amounts(plan["suite"], catalog, short)
    most = max([amount.seeds for amount in found]
               + [sum(shard.seeds) - catalog.first_seed for shard in others if shard.seeds], default=0)
    if catalog.first_seed + most - 1 > catalog.last_seed:
        raise Failure(f"the plan asks for {most} seeds, more than there are from {catalog.first_seed} to {catalog.last_seed}")
    # Shards do not end at the same time: a twentieth is kept for that.
    left = 0.95 * hours * 3600.0 * cores - sum(shard.cost * (cores if shard.alone else 1) for shard in others)
    before = [amount.seeds for amount in found]
    planned = seconds(found, costs)
    if cut(found, costs, left) > left:
        notes.append("the plan takes longer than it may, although all seeds that may be cut are")
    fewer = sum(1 for seeds, amount in zip(before, found) if amount.seeds < seeds)
    if fewer:
        notes.append(f"{fewer} of {len(found)} methods and scenarios get fewer seeds than planned, to keep the time: "
                     f"all would take {(planned - seconds(found, costs)) / 3600.0 / cores:.2f} h more")
    shards = [*suite_shards(found, costs, catalog.first_seed, shard_seconds), *others]
    shards.sort(key=lambda shard: (shard.alone, -shard.cost, shard.name))
    return Plan(shards, found, hours * 3600.0, cores, notes)


def plan_table(plan):
    """The plan as text: a row for each scenario and grade, with the seeds of each method."""
    cells = {}
    for amount in plan.amounts:
        cells.setdefault((amount.scenario, amount.grade), []).append(f"{amount.method} {amount.seeds}")
    lines = [f"{scenario:<28} {grade:<6} {', '.join(cell)}" for (scenario, grade), cell in cells.items()]
    kinds = {}
    for shard in plan.shards:
        count, cost = kinds.get(shard.kind, (0, 0.0))
        kinds[shard.kind] = (count + 1, cost + shard.cost)
    lines.append("")
    lines += [f"{kind:<12} {count:>4} shards {cost / 3600.0:>6.2f} h of one core" for kind, (count, cost) in kinds.items()]
    lines.append(f"about {plan.hours():.2f} h on {plan.cores} idle cores, by script/tables/costs.csv")
    return "\n".join(lines + plan.notes) + "\n"


def read_plan(file=HERE / "plan.toml"):
    with file.open("rb") as stream:
        return tomllib.load(stream)


def printed(cli, *arguments):
    done = subprocess.run([str(cli), *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    return done.stdout if done.returncode == 0 else None


def read_catalog(cli, plan):
    """What the program says that it has."""
    listed = printed(cli, "suite", "--list", "--clips", str(CLIPS))
    blocks_of_seeds = printed(cli, "experiment", "seeds")
    if listed is None or blocks_of_seeds is None:
        raise Failure(f"{cli} has no suite, or no blocks of seeds")
    scenarios = re.findall(r"^\S+ +(\S+) +\d+ seeds ", listed, re.M)
    methods = re.search(r"^methods: (.*)$", listed, re.M)[1].split()
    grades = []
    for grade in dict.fromkeys(grade for rule in plan["suite"] for grade in rule["grades"] if "*" not in grade):
        if printed(cli, "suite", "--list", "--grade", grade) is not None:
            grades.append(grade)
    offered = printed(cli, "experiment", "--help") or ""
    experiments = tuple(dict.fromkeys(re.findall(r"^ +([a-z][a-z0-9-]*)", offered, re.M)))
    people = sorted(name for name in experiments if name.startswith("people-"))
    block = {row["block"]: (int(row["first"]), int(row["last"])) for row in csv.DictReader(blocks_of_seeds.splitlines())}
    if "reporting" not in block or "validation" not in block:
        raise Failure(f"{cli} names no reporting or no validation seeds")
    skipped = re.findall(r"^(\S+ is skipped: .*)$", listed, re.M)
    return Catalog(scenarios, methods, grades, people, *block["reporting"], block["validation"], experiments, skipped)
