"""What compare.py measures: the cases, and the targets printed beside them."""
import dataclasses

# name -> file names to look for in the model folder; shapes are made by the programs themselves
MODELS = {
    'cube': 'shape:cube',
    'torus': 'shape:torus:64:32',
    'cage': 'shape:torus:100:50',
    'rabbit': ['rabbit.obj'],
    'rook': ['catmark_rook.obj', 'rook.obj'],
    'suzanne_quads': ['suzanne_quads.obj'],
    'spot': ['spot_triangulated.obj'],
}


@dataclasses.dataclass
class Case:
    """One row of a table: our command line and those of others. MODEL stands for the model's path."""
    table: str
    name: str
    model: str
    ours: str
    theirs: dict = dataclasses.field(default_factory=dict)  # library -> command line
    target: float = 0.0  # how many times faster than the fastest of them, or an absolute figure
    same_result: str = ''  # library whose result must be the same (mean of x + 2y + 3z)


def refinement_cases(tiny):
    """Uniform refinement from a file in memory to positions and faces; Catmull-Clark, spot with Loop."""
    cases = []
    for model, levels, target in (('suzanne_quads', 4, 10), ('rabbit', 5, 10), ('cube', 9, 10),
                                  ('rook', 5, 7), ('spot', 4, 8)):
        scheme = 'loop' if model == 'spot' else 'catmull-clark'
        options = f'--in MODEL --scheme {scheme} --levels {1 if tiny else levels}'
        theirs = {'OpenSubdiv Far': f'osd_refine {options}'}
        if model != 'rook':  # creases: only OpenSubdiv has them
            theirs['CGAL'] = f'cgal_subdivide {options}'
            if scheme == 'catmull-clark':
                theirs['OpenMesh'] = f'openmesh_subdivide {options}'
        name = f'{model} L{levels}'
        cases.append(Case('refine', name, model, f'limes_refine {options}', theirs, target,
                          'OpenSubdiv Far'))
        cases.append(Case('refine used', name, model, f'limes_refine {options} --memory used',
                          {'OpenSubdiv Far': f'osd_refine {options}'}, target, 'OpenSubdiv Far'))
        # Into used memory: without the time in which the system clears pages.
        cases.append(Case('refine 2 threads', name, model,
                          f'limes_refine {options} --memory used --threads 2',
                          {'limes, 1 thread': f'limes_refine {options} --memory used'}, 1.8,
                          'limes, 1 thread'))
    return cases


def update_cases(tiny):
    """New positions on a topology that stays."""
    cases = []
    for model, levels in (('suzanne_quads', 4), ('rook', 5)):
        options = f'--in MODEL --scheme catmull-clark --levels {1 if tiny else levels}'
        cases.append(Case('update', f'{model} L{levels}', model, f'limes_update {options}',
                          {'stencil table, double': f'osd_stencil {options} --precision double'},
                          2.5, 'stencil table, double'))
    cases.append(Case('update one', '5,000 quads (torus), L4, one vertex moved', 'cage',
                      f'limes_update --in MODEL --levels {1 if tiny else 4} --moved 1', {}, 200e-6))
    return cases


def limit_cases(tiny):
    """Limit points at random (face, u, v)."""
    cases = []
    samples = 1000 if tiny else 1000000
    for model, target in (('torus', 4), ('suzanne_quads', 3), ('rook', 3)):
        for derivatives, what in ((1, 'P and first'), (2, 'P, first and second')):
            options = f'--in MODEL --samples {samples} --derivatives {derivatives}'
            theirs = {'OpenSubdiv patches, level 6': f'osd_evaluate {options} --method patch'}
            if model != 'rook':  # a face that is no quad
                theirs['OpenSubdiv Bfr'] = f'osd_evaluate {options} --method bfr'
            cases.append(Case('limit', f'{model}, {what}', model, f'limes_evaluate {options}', theirs,
                              target if derivatives == 1 else 3))
    return cases


def search_cases(tiny):
    """Closest points: of queries near the surface, and anywhere in a box around it."""
    queries = 1000 if tiny else 100000
    return [Case('closest', f'{model}, {places}', model,
                 f'limes_closest --in MODEL --queries {queries} --places {places}', {}, 10e-6)
            for model in ('torus', 'suzanne_quads', 'rook') for places in ('near', 'box')]


def all_cases(tiny=False):
    return refinement_cases(tiny) + update_cases(tiny) + limit_cases(tiny) + search_cases(tiny)
