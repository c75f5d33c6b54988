"""What a measurement was made on."""
import datetime
import pathlib
import platform
import re
import subprocess

PACKAGES = ['libosd-dev', 'libcgal-dev', 'libopenmesh-dev', 'libtbb-dev', 'libeigen3-dev']


def first_match(pattern, text, fallback='?'):
    found = re.search(pattern, text, re.M)
    return found.group(1).strip() if found else fallback


def output_of(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True).stdout
    except OSError:
        return ''


def compiler_of(build):
    """Compiler, build type and flags from the build folder's cache."""
    cache = (build / 'CMakeCache.txt').read_text()
    compiler = first_match(r'^CMAKE_CXX_COMPILER:\w+=(.*)$', cache)
    version = output_of(compiler, '--version').splitlines()[:1]
    kind = first_match(r'^CMAKE_BUILD_TYPE:\w+=(.*)$', cache)
    flags = first_match(rf'^CMAKE_CXX_FLAGS_{kind.upper()}:\w+=(.*)$', cache, '')
    flags = ' '.join([first_match(r'^CMAKE_CXX_FLAGS:\w+=(.*)$', cache, ''), flags]).strip()
    return f'{(version or ["?"])[0]}, {kind} ({flags})'


def package_versions(packages):
    lines = output_of('dpkg-query', '-W', '-f=${Package} ${Version}\n', *packages).splitlines()
    return ', '.join(line for line in lines if len(line.split()) == 2) or '?'


def describe(build):
    cpu = pathlib.Path('/proc/cpuinfo').read_text()
    memory = int(first_match(r'^MemTotal:\s+(\d+)', pathlib.Path('/proc/meminfo').read_text(), '0'))
    caches = output_of('lscpu')
    return {
        'date': datetime.date.today().isoformat(),
        'processor': first_match(r'^model name\s*:\s*(.*)$', cpu),
        'cores': cpu.count('processor\t'),
        'load before': ' '.join(pathlib.Path('/proc/loadavg').read_text().split()[:3]),
        'caches': ', '.join(f'{n} {first_match(rf"^{n}[^:]*:[ ]*(.*)$", caches)}'
                            for n in ('L1d', 'L2', 'L3')),
        'memory': f'{memory / 2**20:.0f} GiB',
        'system': f'{platform.system()} {platform.release()}',
        'compiler': compiler_of(build),
        'libraries': package_versions(PACKAGES),
    }
