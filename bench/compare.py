#!/usr/bin/env python3
"""Measures limes and other libraries in turn and prints tables of both.

usage: compare.py --build BUILD [--models DIR] [--rounds 5] [--only TEXT] [--tiny]
                  [--json OUT.json] [--update docs/performance.md]

Every measurement is a process of its own (so that its peak memory is its own). All of them are run
once a round, in rounds, so that drift of the machine's speed hits all alike; figures are medians over
the rounds: CPU seconds with one thread, wall-clock seconds with more. BUILD is a build folder with
LIMES_BENCH=ON. A model that is not found is left out and named. --tiny runs everything on small sizes,
to see that it works; its figures mean nothing. --update writes the tables into a page, between its two
marker lines.
"""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys

import comparisons
import machine
import tables

ROOT = pathlib.Path(__file__).resolve().parent.parent
MARKS = '<!-- compare.py: begin -->', '<!-- compare.py: end -->'


def find_models(folders):
    """Model name -> path or shape, and the names that were not found."""
    found = {}
    for name, files in comparisons.MODELS.items():
        if isinstance(files, str):
            found[name] = files
            continue
        paths = (p for folder in folders for f in files for p in sorted(folder.rglob(f)))
        found[name] = next((str(p) for p in paths), None)
    return found, [n for n, p in found.items() if p is None]


def measure(build, command, model):
    """Runs one command line; its JSON line, or None when the program is not there."""
    words = [model if w == 'MODEL' else w for w in shlex.split(command)]
    program = build / 'bench' / words[0]
    if not program.exists():
        return None
    done = subprocess.run([str(program)] + words[1:], capture_output=True, text=True, timeout=1800)
    if done.returncode:
        raise SystemExit(f'{command}: {done.stderr.strip() or done.returncode}')
    return [json.loads(line) for line in done.stdout.splitlines()]


def commands_of(cases, models, tiny):
    """Every different (command line, model path) once."""
    megabytes = 16 if tiny else 1024
    commands = [(f'bandwidth --megabytes {megabytes} --repeats 3 --threads {t}', '') for t in (1, 2)]
    for case in cases:
        for command in [case.ours, *case.theirs.values()]:
            commands.append((command, models[case.model]))
    return list(dict.fromkeys(commands))


def run_rounds(build, commands, rounds):
    """(command line, model path) -> list of JSON lines, one per round (bandwidth: several)."""
    results = {c: [] for c in commands}
    for number in range(rounds):
        for command in commands:
            lines = measure(build, *command)
            if lines is not None:
                results[command] += lines
        print(f'round {number + 1} of {rounds} done', file=sys.stderr)
    return results


def methods_table(build, tiny):
    """What bench/methods prints about itself."""
    command = [str(build / 'bench' / 'limes_methods'), '--points', '4' if tiny else '400']
    return subprocess.run(command, capture_output=True, text=True, check=True, timeout=1800).stdout


def update_page(page, text):
    old = page.read_text()
    if any(old.count(m) != 1 for m in MARKS):
        raise SystemExit(f'{page}: needs one line "{MARKS[0]}" and one "{MARKS[1]}"')
    head, rest = old.split(MARKS[0])
    page.write_text(head + MARKS[0] + '\n' + text + '\n' + MARKS[1] + rest.split(MARKS[1])[1])


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--build', required=True, type=pathlib.Path)
    parser.add_argument('--models', type=pathlib.Path, default=ROOT / 'bench' / 'models')
    parser.add_argument('--rounds', type=int, default=5)
    parser.add_argument('--only', default='', help='only cases with this text in table or name')
    parser.add_argument('--tiny', action='store_true')
    parser.add_argument('--json', type=pathlib.Path)
    parser.add_argument('--update', type=pathlib.Path)
    return parser.parse_args()


def main():
    args = parse_arguments()
    models, missing = find_models([args.models, ROOT / 'bench' / 'models', ROOT / 'data'])
    cases = [c for c in comparisons.all_cases(args.tiny)
             if models[c.model] and args.only in f'{c.table} {c.name}']
    about = machine.describe(args.build) | {'rounds': 1 if args.tiny else args.rounds}
    results = run_rounds(args.build, commands_of(cases, models, args.tiny), about['rounds'])
    if missing:
        about['models not found'] = ', '.join(missing)
    rows = tables.rows_of(cases, models, results)
    limits = tables.limits_of(results)
    text = tables.markdown(about, limits, rows)
    if not args.only or args.only in 'methods':
        text += '\nOther ways to evaluate a limit surface\n\n' + methods_table(args.build, args.tiny)
    print(text)
    if args.json:
        args.json.write_text(json.dumps({'machine': about, 'limits': limits, 'rows': rows}, indent=1))
    if args.update:
        update_page(args.update, text)


if __name__ == '__main__':
    main()
