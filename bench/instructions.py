#!/usr/bin/env python3
"""Counts instructions of small fixed runs and compares them with what is recorded.

usage: instructions.py --build BUILD [--record] [--tolerance 0.05]

A count does not depend on how busy the machine is: a growth of more than 5 % over instructions.json
fails (exit code 1). Two numbers are kept apart. `limes` counts the program itself, limes and what is
compiled into it (Eigen, templates of TBB): baseline x86-64 code, the same on every machine, and it alone
is compared. `libraries` counts shared libraries (libc, libm, TBB), which choose code by the processor
that valgrind shows them: printed, not compared. The compiler, flags and Eigen decide the code: where they
differ from those recorded, nothing can be compared and the exit code is 77 (skipped).
--record writes instructions.json anew: after a change that is meant, with the reason in the commit.
"""
import argparse
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

import machine

RUNS = ['refine', 'set-up', 'evaluate', 'closest', 'assemble']
RECORD = pathlib.Path(__file__).with_name('instructions.json')
SKIPPED = 77


def count_by_object(profile):
    """Own cost per object file. A callgrind file names each object once, as "(id) name"; a line
    "position cost" belongs to the object named last, but after "calls=" it is the cost of the callee."""
    names, costs = {}, collections.Counter()
    current, is_callee, summary = '', False, 0
    for line in profile.read_text().splitlines():
        key, _, value = line.partition('=')
        if key in ('ob', 'cob'):
            number, _, name = value.partition(' ')
            name = names.setdefault(number, name)
            current = name if key == 'ob' else current
        elif key == 'calls':
            is_callee = True
        elif line.startswith('summary: '):
            summary = int(line.split()[1])
        elif line[:1].isdigit():
            costs[current] += 0 if is_callee else int(line.split()[1])
            is_callee = False
    if sum(costs.values()) != summary:
        raise SystemExit(f'{profile}: lines sum to {sum(costs.values())}, not to {summary}')
    return costs


def measure(program, run):
    """Instructions of one run in the program itself and in shared libraries."""
    with tempfile.TemporaryDirectory() as folder:
        profile = pathlib.Path(folder) / 'profile'
        command = ['valgrind', '--tool=callgrind', '--collect-atstart=no', '--compress-pos=no',
                   f'--callgrind-out-file={profile}', str(program), '--run', run]
        done = subprocess.run(command, capture_output=True, text=True, timeout=1200)
        if done.returncode:
            raise SystemExit(f'{" ".join(command)}: {done.stderr}')
        costs = count_by_object(profile)
    own = sum(cost for name, cost in costs.items() if name.endswith('/limes_instructions'))
    if own == 0:
        raise SystemExit(f'{run}: nothing counted; is the program stripped of its name?')
    return {'limes': own, 'libraries': sum(costs.values()) - own}


def tools_of(build):
    """What decides the code: compiler and flags, and the version of Eigen."""
    return {'compiler': machine.compiler_of(build), 'libraries': machine.package_versions(
        ['libeigen3-dev', 'libtbb-dev']), 'valgrind': machine.output_of('valgrind', '--version').strip()}


def compare(counts, recorded, tolerance):
    """Prints both; the runs that grew too much."""
    grown = []
    for run, now in counts.items():
        before = recorded.get(run)
        if before is None:
            print(f'{run:10} {now["limes"]:13,}  not recorded')
            grown.append(run)
            continue
        growth = now['limes'] / before['limes'] - 1
        verdict = 'too much' if growth > tolerance else 'ok'
        print(f'{run:10} {now["limes"]:13,}  recorded {before["limes"]:13,}  {100 * growth:+6.2f} %  '
              f'{verdict}; libraries {now["libraries"]:,} (recorded {before["libraries"]:,})')
        if growth > tolerance:
            grown.append(run)
    return grown


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--build', required=True, type=pathlib.Path)
    parser.add_argument('--record', action='store_true')
    parser.add_argument('--tolerance', type=float, default=0.05)
    args = parser.parse_args()
    program = args.build / 'bench' / 'limes_instructions'
    tools = tools_of(args.build)
    counts = {run: measure(program, run) for run in RUNS}
    if args.record:
        RECORD.write_text(json.dumps({'tools': tools, 'instructions': counts}, indent=1) + '\n')
        print(f'{RECORD}: recorded')
        return 0
    recorded = json.loads(RECORD.read_text())
    grown = compare(counts, recorded['instructions'], args.tolerance)
    if tools != recorded['tools']:
        print(f'skipped: recorded with {recorded["tools"]}, this is {tools}')
        return SKIPPED
    if grown:
        print(f'more than {100 * args.tolerance:g} % more instructions: {", ".join(grown)}')
    return 1 if grown else 0


if __name__ == '__main__':
    sys.exit(main())
