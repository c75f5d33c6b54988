"""From JSON lines to rows with medians and ratios, and to Markdown."""
import statistics

MAX_BYTES_PER_FACE = 60
MAX_TIMES_FILL = 3


def median(lines, *keys):
    """Median over the rounds of the first of the keys that is there; None if none is."""
    for key in keys:
        values = [line[key] for line in lines if line.get(key) is not None]
        if values:
            return statistics.median(values)
    return None


def seconds_of(table, lines):
    """The measured quantity of a table, seconds; smaller is better."""
    if not lines:
        return None
    prefix = '' if table.endswith('2 threads') else 'cpu_'
    if table.startswith('update'):
        return median(lines, prefix + 'seconds_positions')
    if table == 'limit':
        return median(lines, prefix + 'seconds') / lines[0]['samples']
    if table == 'closest':
        return median(lines, prefix + 'seconds') / lines[0]['queries']
    return median(lines, prefix + 'seconds')


def limits_of(results):
    """'fill 1' -> GB per CPU second of a thread and so on: what the machine's memory can do."""
    limits = {}
    for lines in results.values():
        for line in lines:
            if line['library'] == 'bandwidth':
                key = f'{line["kernel"]} {line["threads"]}'
                limits.setdefault(key, []).append(line['gigabytes_per_cpu_second_median'])
    return {key: statistics.median(values) for key, values in limits.items()}


def add_memory(row, lines, limits):
    """Peak memory per face of ours, and time over that of writing the result once at fill and triad speed."""
    first = lines[0]
    used = median(lines, 'peak_rss') - median(lines, 'rss_before')
    row['memory'] = first['memory']
    row['bytes_per_face'] = used / first['out_faces']
    size = 24 * first['out_vertices'] + (12 if first['scheme'] == 'loop' else 16) * first['out_faces']
    for kernel in ('fill', 'triad'):
        row[f'times_{kernel}'] = row['seconds'] / (size / (limits[f'{kernel} 1'] * 1e9))
    row['out_faces'] = first['out_faces']


def judged(row, target):
    """Ratio to the fastest of the others or an absolute target, and whether it is met."""
    row['target'] = target
    others = [s for s in row['others'].values() if s]
    if others:
        row['ratio'] = min(others) / row['seconds']
        row['met'] = row['ratio'] >= target
    elif target < 1:
        row['met'] = row['seconds'] <= target
    return row


def require_same_result(case, ours, theirs):
    """A ratio of times means nothing if the results differ."""
    if not theirs:
        return
    a, b = ours[0]['checksum'], theirs[0]['checksum']
    if abs(a - b) > 1e-8 * (1 + abs(a)):
        raise SystemExit(f'{case.name}: limes {a}, {case.same_result} {b}: the results differ')


def rows_of(cases, models, results):
    """One dict per case whose program is there."""
    limits = limits_of(results)
    rows = []
    for case in cases:
        path = models[case.model]
        ours = results[case.ours, path]
        if not ours:
            continue
        row = {'table': case.table, 'name': case.name, 'method': ours[0].get('method', ''),
               'seconds': seconds_of(case.table, ours), 'others': {}}
        for library, command in case.theirs.items():
            row['others'][library] = seconds_of(case.table, results[command, path])
        if case.same_result:
            require_same_result(case, ours, results[case.theirs[case.same_result], path])
        if case.table in ('refine', 'refine used') and 'fill 1' in limits:
            add_memory(row, ours, limits)
        if case.table == 'limit':
            row['set_up'] = [median(ours, 'cpu_seconds_first_point'),
                             median(ours, 'cpu_seconds_build')]
            row['set_up'] += [median(results[command, path], 'cpu_seconds_build')
                              for command in case.theirs.values()]
        rows.append(judged(row, case.target))
    return rows


def show(seconds):
    """A time with three digits and its unit."""
    if seconds is None:
        return '–'
    for unit, size in (('s', 1.0), ('ms', 1e-3), ('µs', 1e-6)):
        if seconds >= size:
            return f'{seconds / size:.3g} {unit}'
    return f'{seconds * 1e9:.3g} ns'


def times(ratio):
    return '–' if ratio is None else f'{ratio:.1f} ×'


def table(columns, lines):
    head = ['| ' + ' | '.join(columns) + ' |', '|' + '---|' * len(columns)]
    return '\n'.join(head + ['| ' + ' | '.join(line) + ' |' for line in lines])


def ratio_line(row, libraries):
    target = f'{row["target"]:g} ×' if 'ratio' in row else '≤ ' + show(row['target'])
    return ([row['name'], row['method'], show(row['seconds'])]
            + [show(row['others'].get(library)) for library in libraries]
            + [times(row.get('ratio')), target, 'yes' if row.get('met') else 'no'])


def section(rows, key, title, unit):
    """A table of all rows of one kind: ours, the others, ratio to the fastest of them, target."""
    chosen = [r for r in rows if r['table'] == key]
    if not chosen:
        return ''
    libraries = list(dict.fromkeys(library for r in chosen for library in r['others']))
    columns = ['model', 'limes by', f'limes, {unit}', *libraries, 'ratio', 'target', 'met']
    return f'\n{title}\n\n' + table(columns, [ratio_line(r, libraries) for r in chosen]) + '\n'


def memory_line(r):
    return [r['name'], r['memory'], f'{r["out_faces"] / 1e6:.2f}',
            f'{r["out_faces"] / r["seconds"] / 1e6:.1f}', f'{r["bytes_per_face"]:.0f}',
            f'≤ {MAX_BYTES_PER_FACE}', f'{r["times_fill"]:.1f}', f'≤ {MAX_TIMES_FILL}',
            f'{r["times_triad"]:.1f}']


def memory_section(rows):
    chosen = [memory_line(r) for r in rows if 'bytes_per_face' in r]
    if not chosen:
        return ''
    columns = ['model', 'memory', 'million faces', 'million faces/s', 'peak B/face', 'target',
               'time / fill time', 'target', 'time / triad time']
    return ('\nUniform refinement, memory and physical limit (one thread)\n\n'
            + table(columns, chosen) + '\n')


def set_up_section(rows):
    first = {}
    for r in rows:
        if 'set_up' in r:
            first.setdefault(r['name'].split(',')[0], r['set_up'])
    if not first:
        return ''
    lines = [[name, show(s[0]), '≤ 5 ms' if name == 'rook' else '–', show(s[1])]
             + [show(t) for t in s[2:]] + ['–'] * (4 - len(s)) for name, s in first.items()]
    return ('\nLimit surface: set-up\n\n'
            + table(['model', 'limes, to the first point', 'target', 'limes, to a point on every face',
                     'OpenSubdiv patches', 'OpenSubdiv Bfr'], lines) + '\n')


def limits_section(limits):
    kernels = list(dict.fromkeys(key.rsplit(' ', 1)[0] for key in limits))
    lines = [[k] + [f'{limits[f"{k} {t}"]:.1f}' if f'{k} {t}' in limits else '–' for t in (1, 2)]
             for k in kernels]
    return ('\nWhat the memory can do (GB per second of a thread)\n\n'
            + table(['kernel', '1 thread', '2 threads'], lines) + '\n')


def markdown(about, limits, rows):
    text = table(['machine', ''], [[k, str(v)] for k, v in about.items()]) + '\n'
    text += limits_section(limits)
    text += section(rows, 'refine', 'Uniform refinement, Catmull–Clark, one thread', 'time')
    text += section(rows, 'refine used', 'The same into memory that was used before', 'time')
    text += memory_section(rows)
    text += section(rows, 'refine 2 threads', 'Uniform refinement, two threads', '2 threads')
    text += section(rows, 'update', 'New positions, the same topology', 'time')
    text += section(rows, 'update one', 'One vertex moved', 'time')
    text += section(rows, 'limit', 'Limit points at random places, one thread', 'per point')
    text += set_up_section(rows)
    text += section(rows, 'closest', 'Closest point', 'per point')
    return text
