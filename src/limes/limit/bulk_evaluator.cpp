#include "limes/limit/bulk_evaluator.h"

#include <algorithm>
#include <limits>
#include <new>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/limit/deep_tile.h"

namespace limes {
namespace {

constexpr std::align_val_t tile_alignment{alignof(TileCoefficients)};

double* allocate(std::int64_t count) {
  return static_cast<double*>(
      ::operator new(static_cast<std::size_t>(count) * sizeof(double), tile_alignment));
}
void release(double* numbers) {
  ::operator delete(numbers, tile_alignment);
}

}  // namespace

BulkEvaluator::BulkEvaluator(const LimitBasis& basis, std::span<const Vec3> points)
    : basis_(&basis),
      points_(points.begin(), points.end()),
      faces_(static_cast<std::size_t>(basis.topology().num_faces())),
      tree_of_kind_(static_cast<std::size_t>(basis.kinds().size())) {
  LIMES_ASSERT(static_cast<int>(points.size()) == basis.topology().num_vertices());
  require_squares(basis.scheme(), "bulk evaluation");
}

BulkEvaluator::~BulkEvaluator() {
  for (const Face& face : faces_)
    release(face.numbers.load(std::memory_order_relaxed));
}

const TileTree& BulkEvaluator::tree_of(FaceId f) const {
  const int kind = basis_->kind(f);
  auto& known = tree_of_kind_[static_cast<std::size_t>(kind)];
  if (const TileTree* tree = known.load(std::memory_order_acquire)) return *tree;
  auto tree = std::make_unique<const TileTree>(
      build_tile_tree(basis_->kinds(), kind, basis_->topology().face_size(f)));
  const std::lock_guard lock(mutex_);
  if (const TileTree* other = known.load(std::memory_order_relaxed)) return *other;
  trees_.push_back(std::move(tree));
  known.store(trees_.back().get(), std::memory_order_release);
  return *trees_.back();
}

/// Several threads may make the same face: all find the same numbers, and one's are kept.
const double* BulkEvaluator::make_face(FaceId f) const {
  const TileTree& tree = tree_of(f);
  double* numbers = allocate(tree.size);
  TileFiller().fill(basis_->kinds(), tree, basis_->controls(f), points_, numbers);
  Face& face = faces_[static_cast<std::size_t>(f.value)];
  const bool one_tile = tree.roots.size() == 1 && tree.roots[0] == ~0 && tree.deep.empty();
  face.tree.store(one_tile ? nullptr : &tree, std::memory_order_relaxed);
  double* expected = nullptr;
  if (face.numbers.compare_exchange_strong(expected, numbers, std::memory_order_acq_rel))
    return numbers;
  release(numbers);
  return expected;
}

void BulkEvaluator::update(std::span<const Vec3> points) {
  LIMES_ASSERT(points.size() == points_.size());
  std::copy(points.begin(), points.end(), points_.begin());
  for_each_block(
      static_cast<std::int64_t>(faces_.size()), 64, [&](std::int64_t begin, std::int64_t end) {
        TileFiller filler;
        for (std::int64_t i = begin; i < end; ++i) {
          const FaceId f(i);
          double* numbers = faces_[static_cast<std::size_t>(i)].numbers.load();
          if (numbers)
            filler.fill(basis_->kinds(), tree_of(f), basis_->controls(f), points_, numbers);
        }
      });
}

/// A few points at a time: first the tile of each, then the values of all, so that tiles are on
/// their way from memory while others are looked up.
class BulkEvaluator::Block {
 public:
  static constexpr std::size_t size = 32;

  explicit Block(const BulkEvaluator& of) : of_(of) {}

  /// @param first  index of where[0] for extraordinary
  void evaluate(std::span<const SurfaceLocation> where, int order, const TileValues& out) {
    num_special_ = 0;
    for (std::size_t i = 0; i < where.size(); ++i)
      find_tile(where[i], i);
    evaluate_tiles({points_.data(), where.size()}, order, out);
    for (std::size_t k = 0; k < num_special_; ++k)
      finish(special_[k], order, out);
  }

  /// Calls use(i) for the points of the last evaluate() that are extraordinary, ascending.
  template <class Use>
  void for_each_extraordinary(const Use& use) const {
    for (std::size_t k = 0; k < num_special_; ++k)
      if (special_[k].point.kind == LimitBasis::Point::extraordinary) use(special_[k].index);
  }

 private:
  struct Special {
    std::size_t index;
    DeepPoint point;
  };

  void find_tile(const SurfaceLocation& where, std::size_t i) {
    const Face& face = of_.faces_[static_cast<std::size_t>(where.face.value)];
    const double* numbers = face.numbers.load(std::memory_order_acquire);
    if (!numbers) [[unlikely]]
      numbers = of_.make_face(where.face);
    const double u = where.uv.x();
    const double v = where.uv.y();
    if (const TileTree* tree = face.tree.load(std::memory_order_relaxed)) {
      std::int32_t at = tree->roots[static_cast<std::size_t>(where.corner)];
      while (at >= 0) {
        const TileTree::Node& node = tree->nodes[static_cast<std::size_t>(at)];
        at = node.next[(u > node.u ? 1U : 0U) + (v > node.v ? 2U : 0U)];
      }
      const int deep = ~at - static_cast<int>(tree->tiles.size());
      if (deep >= 0) [[unlikely]]
        return find_deep(*tree, deep, numbers, where.uv, i);
      numbers += std::size_t{TileTree::numbers_per_tile} * static_cast<std::size_t>(~at);
    }
    prefetch(numbers);
    points_[i] = {numbers, u, v};
  }

  static void prefetch(const double* tile) {
#if defined(__GNUC__)
    for (int line = 0; line < TileTree::numbers_per_tile; line += 8)
      __builtin_prefetch(tile + line);
#else
    (void)tile;
#endif
  }

  void find_deep(const TileTree& tree, int deep, const double* numbers, const Vec2& uv,
                 std::size_t i) {
    Special& special = special_[num_special_];
    special.index = i;
    special.point = deep_tile(of_.basis_->kinds(), tree, deep, numbers, uv,
                              special_tiles_[num_special_], points_[i]);
    ++num_special_;
  }

  static void finish(const Special& special, int order, const TileValues& out) {
    const bool exists = special.point.kind == LimitBasis::Point::ordinary;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double scale = exists ? std::ldexp(1.0, special.point.depth) : nan;
    const auto multiply = [&](double* values, double by) {
      for (std::size_t k = 3 * special.index; k < 3 * special.index + 3; ++k)
        values[k] *= by;
    };
    if (order >= 1) {
      multiply(out.xu, scale);
      multiply(out.xv, scale);
    }
    if (order >= 2) {
      multiply(out.xuu, scale * scale);
      multiply(out.xuv, scale * scale);
      multiply(out.xvv, scale * scale);
    }
  }

  const BulkEvaluator& of_;
  std::array<TilePoint, size> points_;
  std::array<Special, size> special_;
  std::array<TileCoefficients, size> special_tiles_;
  std::size_t num_special_ = 0;
};

LimitBasis::Point BulkEvaluator::evaluate(const SurfaceLocation& where, int order,
                                          SurfaceJet& out) const {
  LIMES_ASSERT(order >= 0 && order <= 2);
  Block block(*this);
  block.evaluate(
      {&where, 1}, order,
      {out.x.data(), out.xu.data(), out.xv.data(), out.xuu.data(), out.xuv.data(), out.xvv.data()});
  LimitBasis::Point kind = LimitBasis::Point::ordinary;
  block.for_each_extraordinary([&](std::size_t) { kind = LimitBasis::Point::extraordinary; });
  return kind;
}

void BulkEvaluator::evaluate(std::span<const SurfaceLocation> where, int order,
                             SurfaceValues& out) const {
  LIMES_ASSERT(order >= 0 && order <= 2);
  const std::size_t n = where.size();
  out.x.resize(n);
  for (auto* values : {&out.xu, &out.xv})
    values->resize(order >= 1 ? n : 0);
  for (auto* values : {&out.xuu, &out.xuv, &out.xvv})
    values->resize(order >= 2 ? n : 0);
  out.extraordinary.clear();
  std::mutex mutex;
  for_each_block(static_cast<std::int64_t>(n), 1 << 14, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    Block block(*this);
    const auto last = static_cast<std::size_t>(end);
    for (auto at = static_cast<std::size_t>(begin); at < last; at += Block::size) {
      const auto from = [&](std::vector<Vec3>& values) {
        return values.empty() ? nullptr : values[at].data();
      };
      block.evaluate(
          where.subspan(at, std::min(Block::size, last - at)), order,
          {from(out.x), from(out.xu), from(out.xv), from(out.xuu), from(out.xuv), from(out.xvv)});
      block.for_each_extraordinary([&](std::size_t i) {
        const std::lock_guard lock(mutex);
        out.extraordinary.push_back(static_cast<std::int64_t>(at + i));
      });
    }
  });
  std::sort(out.extraordinary.begin(), out.extraordinary.end());
}

}  // namespace limes
