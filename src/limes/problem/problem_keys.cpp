#include "limes/problem/problem_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "limes/core/text.h"
#include "limes/subdiv/schemes.h"

namespace limes::problem_file {
namespace {

constexpr std::array tables{
    Table{"units", TableForm::single, Need::optional, "names of your units, for reports only"},
    Table{"mesh", TableForm::single, Need::required, "the surface and the space on it"},
    Table{"geometry", TableForm::single_or_list, Need::optional,
          "an exact surface to place vertices on; several with part"},
    Table{"curve", TableForm::list, Need::optional,
          "boundary edges that follow a curve of the exact surface"},
    Table{"seam", TableForm::list, Need::optional, "parts tied along their boundaries"},
    Table{"model", TableForm::single, Need::required, "the equations"},
    Table{"material", TableForm::single_or_list, Need::required,
          "what the surface is made of; several with where"},
    Table{"periodic", TableForm::single, Need::optional, "a periodic cell and what deforms it"},
    Table{"support", TableForm::list, Need::optional,
          "what is held; at least one, unless there is [periodic]"},
    Table{"load", TableForm::list, Need::optional, "what acts; loads add up"},
    Table{"probe", TableForm::list, Need::optional, "points whose values are reported"},
    Table{"adapt", TableForm::single, Need::optional, "refinement where the error is"}};

constexpr std::array keys{
    Key{.table = "", .name = "title", .help = "heading of the report"},

    Key{.table = "units", .name = "length", .help = "such as mm"},
    Key{.table = "units", .name = "force", .help = "such as N"},

    Key{.table = "mesh",
        .name = "file",
        .need = Need::required,
        .help = "control mesh, .obj .off .ply .stl; relative to the folder of the problem file"},
    Key{.table = "mesh",
        .name = "scheme",
        .type = ValueType::name,
        .initial = "catmull-clark",
        .help = "the space: limit functions of this scheme; linear is bilinear elements"},
    Key{.table = "mesh",
        .name = "levels",
        .type = ValueType::integer,
        .range = from_to(0, 12),
        .initial = "0",
        .help = "uniform refinements before the analysis"},
    Key{.table = "mesh",
        .name = "placement",
        .type = ValueType::name,
        .choices = "scheme exact",
        .later_choices = "kobbelt linear",
        .initial = "scheme",
        .help = "where the vertices of a refinement go: the scheme's own rule, or halfway and then "
                "onto the surface of [geometry] (mitc4 only)"},

    Key{.table = "mesh",
        .name = "junctions",
        .type = ValueType::name,
        .choices = "refused tied",
        .initial = "refused",
        .help = "edges with three faces or more: refused, or cut and tied like a [[seam]] (mitc4 "
                "only)"},
    Key{.table = "mesh",
        .name = "smooth_start",
        .type = ValueType::integer,
        .range = from_to(0, 1000),
        .initial = "0",
        .help =
            "most sweeps in which the shapes of the control faces are optimised, vertices sliding "
            "on [geometry] (mitc4 only)"},
    Key{.table = "mesh",
        .name = "smoothing",
        .type = ValueType::integer,
        .range = from_to(0, 1000),
        .initial = "0",
        .help = "the same after each refinement: with placement exact on [geometry], with kobbelt "
                "new vertices on the scheme's surface (mitc4 only)"},

    Key{.table = "geometry",
        .name = "kind",
        .type = ValueType::name,
        .need = Need::required,
        .choices = "cylinder sphere plane cone torus graph formula",
        .help = "of the exact surface"},
    Key{.table = "geometry",
        .name = "part",
        .help = "the part (OBJ 'o') whose surface it is; without it: of all without their own"},
    Key{.table = "geometry",
        .name = "point",
        .type = ValueType::point,
        .initial = "[0, 0, 0]",
        .help =
            "a point of the cylinder's axis or of the plane, the centre of the sphere or torus, "
            "the cone's apex"},
    Key{.table = "geometry",
        .name = "axis",
        .type = ValueType::point,
        .initial = "[0, 0, 1]",
        .help =
            "direction of the axis of the cylinder or torus, of the cone from its apex; normal of "
            "the plane, required there"},
    Key{.table = "geometry",
        .name = "radius",
        .type = ValueType::number,
        .range = above(0),
        .help =
            "of the cylinder or sphere, in the middle of the thickness, or of the circle in the "
            "middle of the torus's tube; required there"},
    Key{.table = "geometry",
        .name = "tube_radius",
        .type = ValueType::number,
        .range = above(0),
        .help = "of the torus's tube, less than radius; required there"},
    Key{.table = "geometry",
        .name = "angle",
        .type = ValueType::number,
        .range = between(0, 90),
        .help = "degrees between the cone's axis and the cone; required there"},
    Key{.table = "geometry",
        .name = "height",
        .type = ValueType::formula,
        .help = "z of the graph, a formula in x and y; required there"},
    Key{.table = "geometry",
        .name = "zero",
        .type = ValueType::formula,
        .help = "a smooth formula in x, y, z that is 0 on the surface; required for a formula"},

    Key{.table = "curve",
        .name = "where",
        .type = ValueType::selection,
        .need = Need::required,
        .help = "boundary edges of the control mesh, both ends selected"},
    Key{.table = "curve",
        .name = "zero",
        .type = ValueType::formula,
        .need = Need::required,
        .help = "a smooth formula in x, y, z that is 0 on the curve"},

    Key{.table = "seam",
        .name = "parts",
        .type = ValueType::texts,
        .need = Need::required,
        .help = "names of the parts (OBJ 'o'), two or more"},

    Key{.table = "model",
        .name = "kind",
        .type = ValueType::name,
        .need = Need::required,
        .choices = "plane-stress plane-strain poisson mitc4",
        .later_choices = "kirchhoff-love laplace-beltrami",
        .help = "plane elasticity or Poisson's equation in the x-y plane, or shells of four-node "
                "elements"},
    Key{.table = "model",
        .name = "boundary",
        .type = ValueType::name,
        .choices = "free phantom",
        .initial = "free",
        .help =
            "beyond the boundary: free ghost points, or phantom points, which follow the others"},
    Key{.table = "model",
        .name = "kinks",
        .type = ValueType::boolean,
        .initial = "true",
        .help = "the field may kink where materials meet"},
    Key{.table = "model",
        .name = "quadrature_points",
        .type = ValueType::integer,
        .range = from_to(2, 8),
        .initial = "3",
        .help = "Gauss points per direction and tile"},
    Key{.table = "model",
        .name = "quadrature_depth",
        .type = ValueType::integer,
        .range = from_to(0, 30),
        .initial = "4",
        .help = "rings of tiles around an extraordinary vertex"},
    Key{.table = "model",
        .name = "shear_factor",
        .type = ValueType::number,
        .range = above(0),
        .initial = "5/6",
        .help = "mitc4: factor of the transverse shear stiffness"},
    Key{.table = "model",
        .name = "kink_angle",
        .type = ValueType::number,
        .range = from_to(1, 90),
        .initial = "20",
        .help = "mitc4: faces that meet at more degrees than this have directors of their own"},
    Key{.table = "model",
        .name = "membrane",
        .type = ValueType::name,
        .choices = "displacement assumed",
        .initial = "displacement",
        .help =
            "mitc4: membrane strains of the displacements, or assumed ones that do not lock thin "
            "warped elements (MITC4+)"},

    Key{.table = "model",
        .name = "drilling",
        .type = ValueType::number,
        .range = from_to(0, 1),
        .initial = "0",
        .help = "mitc4: at kinks, stiffness against rotations about a face's normal that are not "
                "those of its plane, as a part of the shear stiffness"},

    Key{.table = "material",
        .name = "where",
        .type = ValueType::selection,
        .help = "faces of this material; without it: all that no other material takes"},
    Key{.table = "material",
        .name = "young",
        .type = ValueType::number,
        .range = above(0),
        .help = "Young's modulus; required except by poisson"},
    Key{.table = "material",
        .name = "poisson",
        .type = ValueType::number,
        .range = between(-1, 0.5),
        .help = "Poisson's ratio; required except by poisson"},
    Key{.table = "material",
        .name = "thickness",
        .type = ValueType::number,
        .range = above(0),
        .initial = "1",
        .help = "extent across the surface"},
    Key{.table = "material",
        .name = "conductivity",
        .type = ValueType::number,
        .range = above(0),
        .initial = "1",
        .help = "poisson: flux per gradient"},

    Key{.table = "periodic",
        .name = "gradient",
        .type = ValueType::matrix,
        .need = Need::required,
        .help = "deformation gradient F of the cell, [[Fxx, Fxy], [Fyx, Fyy]], determinant > 0"},

    Key{.table = "support",
        .name = "where",
        .type = ValueType::selection,
        .need = Need::required,
        .help = "what is held: boundary edges with both ends selected along their length, other "
                "vertices at their points"},
    Key{.table = "support",
        .name = "fix",
        .type = ValueType::names,
        .need = Need::one_of,
        .choices = "ux uy uz rx ry rz",
        .help = "displacements and rotations (mitc4 only) that are zero there"},
    Key{.table = "support",
        .name = "kind",
        .type = ValueType::name,
        .need = Need::one_of,
        .choices = "clamped supported symmetry diaphragm",
        .help = "mitc4: a usual support of boundary edges by its name"},
    Key{.table = "support",
        .name = "value",
        .type = ValueType::formula,
        .need = Need::one_of,
        .help = "poisson: the solution at the selected vertices"},
    Key{.table = "support",
        .name = "rotation",
        .type = ValueType::name,
        .choices = "hard soft",
        .initial = "soft",
        .help = "of supported and diaphragm: hard holds the director along the edge as well"},

    Key{.table = "load",
        .name = "where",
        .type = ValueType::selection,
        .need = Need::required,
        .help = "faces, boundary edges or vertices on which it acts"},
    Key{.table = "load",
        .name = "force",
        .type = ValueType::formula_vector,
        .need = Need::one_of,
        .help = "at the limit point of each selected vertex"},
    Key{.table = "load",
        .name = "force_per_length",
        .type = ValueType::formula_vector,
        .need = Need::one_of,
        .help = "along the selected boundary edges"},
    Key{.table = "load",
        .name = "force_per_area",
        .type = ValueType::formula_vector,
        .need = Need::one_of,
        .help = "on the selected faces, per area of the middle surface"},
    Key{.table = "load",
        .name = "force_per_volume",
        .type = ValueType::formula_vector,
        .need = Need::one_of,
        .help = "on the selected faces, times the thickness"},
    Key{.table = "load",
        .name = "pressure",
        .type = ValueType::formula,
        .need = Need::one_of,
        .help = "on the selected boundary edges, times the thickness, against the outward normal; "
                "mitc4: on the selected faces, against their normal"},
    Key{.table = "load",
        .name = "moment",
        .type = ValueType::formula_vector,
        .need = Need::one_of,
        .help = "at each selected vertex, mitc4 only"},
    Key{.table = "load",
        .name = "source",
        .type = ValueType::formula,
        .need = Need::one_of,
        .help = "poisson: on the selected faces, per area"},
    Key{.table = "load",
        .name = "flux",
        .type = ValueType::formula,
        .need = Need::one_of,
        .help = "poisson: through the selected boundary edges into the body, per length"},

    Key{.table = "probe",
        .name = "name",
        .need = Need::required,
        .help = "heading of its results; no two alike"},
    Key{.table = "probe",
        .name = "at",
        .type = ValueType::point,
        .need = Need::required,
        .help = "[x, y] or [x, y, z]; the nearest point of the surface is taken"},

    Key{.table = "adapt",
        .name = "estimator",
        .type = ValueType::name,
        .choices = "zienkiewicz-zhu residual",
        .initial = "zienkiewicz-zhu",
        .help =
            "how the error in the energy norm is estimated: by recovered fluxes or stresses, or by "
            "what is left unbalanced"},
    Key{.table = "adapt",
        .name = "closure",
        .type = ValueType::name,
        .choices = "conforming hanging",
        .initial = "conforming",
        .help = "where finer elements meet coarser ones: the coarser are cut into quads, or "
                "vertices of "
                "the finer hang in their sides, held by conditions"},
    Key{.table = "adapt",
        .name = "mark",
        .type = ValueType::name,
        .choices = "doerfler maximum fraction",
        .initial = "doerfler",
        .help = "which elements are refined: the worst that together have a share of the squared "
                "error; those above a share of the largest error; a share of all"},
    Key{.table = "adapt",
        .name = "share",
        .type = ValueType::number,
        .range = {.low = 0, .high = 1, .low_open = true},
        .initial = "0.5",
        .help = "of `mark`"},
    Key{.table = "adapt",
        .name = "target_error",
        .type = ValueType::number,
        .range = between(0, 1),
        .help = "stop when the estimated error is at most this part of the energy norm"},
    Key{.table = "adapt",
        .name = "max_dofs",
        .type = ValueType::integer,
        .range = from_to(1, 100'000'000),
        .initial = "10000",
        .help =
            "stop before a mesh with more vertices times unknowns per vertex than this; the first "
            "one is always solved"},
    Key{.table = "adapt",
        .name = "max_steps",
        .type = ValueType::integer,
        .range = from_to(1, 100),
        .initial = "30",
        .help = "most solutions"},
    Key{.table = "adapt",
        .name = "max_seconds",
        .type = ValueType::number,
        .range = above(0),
        .help = "no further step after this time"},
    Key{.table = "adapt",
        .name = "reference_energy",
        .type = ValueType::number,
        .range = above(0),
        .help = "strain energy of the exact solution, to report true errors; with supports of "
                "value 0 only"},
    Key{.table = "adapt",
        .name = "reference_levels",
        .type = ValueType::integer,
        .range = from_to(0, 4),
        .initial = "0",
        .help =
            "each step is also solved with every element split so often, to report errors against "
            "that; 0: not, 2 finds some 97 % of the error, with 16 times the unknowns"}};

std::string scheme_names() {
  std::string names;
  for (const Scheme& scheme : all_schemes())
    names.append(scheme.name).push_back(' ');
  return names;
}

/// The table, with what other modules have to say.
std::vector<Key> complete_keys() {
  static const std::string schemes = scheme_names();
  std::vector<Key> result(keys.begin(), keys.end());
  for (Key& key : result)
    if (key.table == "mesh" && key.name == "scheme") key.choices = schemes;
  return result;
}

std::string describe_range(const Range& range, std::string_view noun) {
  if (range.high == std::numeric_limits<double>::infinity()) {
    if (range.low == -range.high) return std::string(noun);
    return fmt::format("{} {} {}", noun, range.low_open ? ">" : ">=", range.low);
  }
  if (range.low_open && !range.high_open)
    return fmt::format("{} > {} and <= {}", noun, range.low, range.high);
  if (range.low_open && range.high_open)
    return fmt::format("{} between {} and {}, both excluded", noun, range.low, range.high);
  return fmt::format("{} from {} to {}", noun, range.low, range.high);
}

}  // namespace

bool Range::contains(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::span<const Table> problem_tables() {
  return tables;
}

std::span<const Key> problem_keys() {
  static const std::vector<Key> all = complete_keys();
  return all;
}

const Table* find_table(std::string_view name) {
  const auto table =
      std::find_if(tables.begin(), tables.end(), [&](const Table& t) { return t.name == name; });
  return table == tables.end() ? nullptr : &*table;
}

const Key* find_key(std::string_view table, std::string_view name) {
  for (const Key& key : problem_keys())
    if (key.table == table && key.name == name) return &key;
  return nullptr;
}

std::vector<std::string_view> names_in(std::string_view table) {
  std::vector<std::string_view> names;
  for (const Key& key : problem_keys())
    if (key.table == table && key.need != Need::later) names.push_back(key.name);
  for (const Table& t : tables)
    if (table.empty() && t.need != Need::later) names.push_back(t.name);
  return names;
}

std::string written(const Table& table) {
  return table.form == TableForm::list ? fmt::format("[[{}]]", table.name)
                                       : fmt::format("[{}]", table.name);
}

std::vector<std::string_view> split_words(std::string_view words) {
  std::vector<std::string_view> result;
  while (!(words = trim(words)).empty())
    result.push_back(next_token(words));
  return result;
}

std::string describe_value(const Key& key) {
  switch (key.type) {
    case ValueType::text:
      return "text";
    case ValueType::name: {
      const auto choices = split_words(key.choices);
      return fmt::format("{}{}", choices.size() > 1 ? "one of " : "", fmt::join(choices, ", "));
    }
    case ValueType::names:
      return fmt::format("a list of {}", fmt::join(split_words(key.choices), ", "));
    case ValueType::texts:
      return "a list of texts";
    case ValueType::integer:
      return describe_range(key.range, "an integer");
    case ValueType::number:
      return describe_range(key.range, "a number");
    case ValueType::boolean:
      return "true or false";
    case ValueType::formula:
      return "a number or a formula";
    case ValueType::formula_vector:
      return "two or three numbers or formulas";
    case ValueType::point:
      return "two or three numbers";
    case ValueType::matrix:
      return "2 x 2 numbers";
    case ValueType::selection:
      return "a selection";
  }
  return {};
}

}  // namespace limes::problem_file
