#include "limes/spectrum/characteristic_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "limes/report/legend.h"

namespace limes {
namespace {

constexpr double panel = 250;       // side of a map
constexpr double text_height = 62;  // below it
constexpr double gap = 26;
constexpr double head = 78;
constexpr int most_columns = 4;
constexpr int most_rings = 18;
constexpr std::size_t most_periods = 4;

constexpr Colour tint_a = Colour::hex(0xdbe6f2);
constexpr Colour tint_b = Colour::hex(0xf6ecd9);
constexpr Colour fine_line = Colour::hex(0x8b97a5);

/// From the coordinates of a map to the paper.
class Frame {
 public:
  Frame(const Vec2& corner, double reach)
      : centre_(corner + Vec2::Constant(panel / 2)), scale_(panel / 2 / reach) {}
  Vec2 operator()(const Vec2& x) const { return centre_ + scale_ * Vec2(x.x(), -x.y()); }
  [[nodiscard]] const Vec2& centre() const { return centre_; }

 private:
  Vec2 centre_;
  double scale_;
};

class MapPanel {
 public:
  MapPanel(const Analysis& analysis, int factor)
      : local_(*analysis.local), map_(*analysis.spectrum.map), factor_(factor) {
    outer_ = std::min(local_.places().back().ring, most_rings);
    place_ =
        IdArray<VertexId, int>(static_cast<std::size_t>(local_.star().topology.num_vertices()), -1);
    for (std::size_t p = 0; p < local_.vertices().size(); ++p)
      place_[local_.vertices()[p]] = static_cast<int>(p);
    for (std::size_t p = 0; p < map_.points.size(); ++p)
      if (local_.places()[p].ring <= outer_) reach_ = std::max(reach_, map_.points[p].norm());
  }

  void draw(Canvas& canvas, const Vec2& corner) const {
    const Frame frame(corner, reach_);
    draw_periods(canvas, frame);
    draw_lines(canvas, frame);
    canvas.circle(frame.centre(), 3.2, {palette::series[1], Stroke{palette::paper, 1.0}});
  }

 private:
  Vec2 point(VertexId v) const { return map_.points[static_cast<std::size_t>(place_[v])]; }
  int ring(VertexId v) const { return local_.walk().ring(v); }

  /// The discs within the rings where periods end, largest first, in alternating tints.
  void draw_periods(Canvas& canvas, const Frame& frame) const {
    bool even = true;
    for (const int ring : period_ends()) {
      std::vector<Vec2> outline = outline_of(ring);
      for (Vec2& x : outline)
        x = frame(x);
      canvas.polygon(outline, {even ? tint_a : tint_b, Stroke{palette::ink, 1.3}});
      even = !even;
    }
  }
  [[nodiscard]] std::vector<int> period_ends() const {
    std::vector<int> rings;
    for (int ring = outer_; ring > 0 && rings.size() < most_periods; ring /= factor_)
      rings.push_back(ring);
    return rings;
  }
  /// Around the faces within a ring, counter-clockwise.
  [[nodiscard]] std::vector<Vec2> outline_of(int ring) const {
    const Adjacency& adjacency = local_.walk().adjacency();
    const auto inside = [&](HalfedgeId h) {
      return h.valid() && local_.walk().outer_ring(adjacency.face(h)) <= ring;
    };
    HalfedgeId start(0);
    while (!inside(start) || inside(adjacency.twin(start)))
      start = HalfedgeId(start.value + 1);
    std::vector<Vec2> outline;
    HalfedgeId h = start;
    do {
      outline.push_back(point(adjacency.from(h)));
      h = adjacency.next(h);
      while (inside(adjacency.twin(h)))
        h = adjacency.next(adjacency.twin(h));
    } while (h != start);
    return outline;
  }

  /// Edges in thin lines, as far as they go straight on through vertices.
  void draw_lines(Canvas& canvas, const Frame& frame) const {
    const Adjacency& adjacency = local_.walk().adjacency();
    std::vector<bool> drawn(static_cast<std::size_t>(adjacency.num_edges()), false);
    std::vector<Vec2> line;
    for (int e = 0; e < adjacency.num_edges(); ++e) {
      HalfedgeId h = adjacency.halfedge(EdgeId(e));
      if (drawn[static_cast<std::size_t>(e)] || !shows(h)) continue;
      // Back to where the line starts, then along it.
      for (HalfedgeId back = straight_on(adjacency.twin(h));
           back.valid() && adjacency.edge(back) != EdgeId(e); back = straight_on(back))
        h = adjacency.twin(back);
      line.assign(1, frame(point(adjacency.from(h))));
      for (; h.valid() && !drawn[static_cast<std::size_t>(adjacency.edge(h).value)];
           h = straight_on(h)) {
        drawn[static_cast<std::size_t>(adjacency.edge(h).value)] = true;
        line.push_back(frame(point(adjacency.to(h))));
      }
      canvas.polyline(line, Stroke{fine_line, 0.45});
    }
  }
  /// Whether an edge is drawn; those at the rim of the star have no twin and are not.
  [[nodiscard]] bool shows(HalfedgeId h) const {
    const Adjacency& adjacency = local_.walk().adjacency();
    return h.valid() && adjacency.twin(h).valid() &&
           std::max(ring(adjacency.from(h)), ring(adjacency.to(h))) <= outer_;
  }
  /// The edge opposite to h at its end; invalid where there is none, or it is not drawn.
  [[nodiscard]] HalfedgeId straight_on(HalfedgeId h) const {
    const Adjacency& adjacency = local_.walk().adjacency();
    const VertexId v = adjacency.to(h);
    const int valence = adjacency.num_ring_faces(v);
    if (ring(v) == 0 || adjacency.is_boundary(v) || valence % 2 != 0) return {};
    HalfedgeId on = adjacency.twin(h);
    for (int i = 0; i < valence / 2; ++i)
      on = adjacency.ring_next(on);
    return shows(on) ? on : HalfedgeId();
  }

  const LocalSubdivision& local_;
  const CharacteristicMap& map_;
  int factor_;
  int outer_;
  double reach_ = 0;
  IdArray<VertexId, int> place_;
};

void draw_labels(Canvas& canvas, const Spectrum& s, const Vec2& corner) {
  const TextStyle bold{.size = 14, .bold = true};
  const TextStyle plain{.size = 12, .colour = palette::muted};
  Vec2 at = corner + Vec2(0, panel + 20);
  canvas.text(at, fmt::format("valence {}", s.valence), bold);
  canvas.text(at + Vec2(panel, 0), s.c1 ? "C1" : "not C1",
              {.size = 13,
               .colour = s.c1 ? palette::series[2] : palette::series[1],
               .anchor = Anchor::end,
               .bold = true});
  at.y() += 18;
  canvas.text(at, fmt::format("λ = {:.6f},  |μ|/λ² = {:.4f}", s.subdominant, s.curvature_ratio),
              plain);
  at.y() += 17;
  if (s.map)
    canvas.text(at,
                fmt::format("least Jacobian {:.3f} of the mean, winds {}", s.map->least_jacobian,
                            s.map->winding_number),
                plain);
}

void draw_missing(Canvas& canvas, const Spectrum& s, const Vec2& corner) {
  canvas.rectangle(corner, Vec2::Constant(panel),
                   {Colour::hex(0xf4f5f6), Stroke{palette::rule, 1.0}});
  const TextStyle style{.size = 12, .colour = palette::muted, .anchor = Anchor::middle};
  canvas.text(corner + Vec2(panel / 2, panel / 2 - 8), "no characteristic map:", style);
  const std::size_t colon = std::min(s.reason.find(':'), s.reason.size());
  canvas.text(corner + Vec2(panel / 2, panel / 2 + 10), s.reason.substr(0, colon),
              {.size = 10.5, .colour = palette::muted, .anchor = Anchor::middle});
}

}  // namespace

Drawing characteristic_picture(const Scheme& scheme, std::span<const Analysis> results) {
  const int count = static_cast<int>(results.size());
  const int columns = std::clamp(count, 1, most_columns);
  const int lines = (count + columns - 1) / columns;
  Drawing drawing;
  drawing.width = std::max(2 * gap + columns * panel + (columns - 1) * gap, 470.0);
  drawing.height = head + lines * (panel + text_height + gap);
  const std::string title = fmt::format("Characteristic maps of {}", scheme.name);
  drawing.description = title;
  drawing.draw = [=](Canvas& canvas) {
    canvas.text({gap, 34}, title, {.size = 18, .bold = true});
    canvas.text({gap, 55}, "Two tints: one period of the scheme each, a smaller copy of the next.",
                {.size = 12.5, .colour = palette::muted});
    for (int i = 0; i < count; ++i) {
      const Analysis& a = results[static_cast<std::size_t>(i)];
      const Vec2 corner(gap + (i % columns) * (panel + gap),
                        head + (i / columns) * (panel + text_height + gap));
      if (a.spectrum.map)
        MapPanel(a, rings_per_period(scheme)).draw(canvas, corner);
      else
        draw_missing(canvas, a.spectrum, corner);
      draw_labels(canvas, a.spectrum, corner);
    }
  };
  return drawing;
}

}  // namespace limes
