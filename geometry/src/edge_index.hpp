// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "exact.hpp"

namespace brash::geometry {

/// Where edges are: a grid of square cells for every power of two of the edges' extent, hashed.
///
/// An edge lives on the level whose cells are just not smaller than its box, so in at most four cells, however long it
/// is; a query looks at the cells of each level in use. Insertion, removal and a query of fixed size therefore cost the
/// same in a sheet of any size, and straight sides need no splitting.
class EdgeIndex {
 public:
  void insert(int edge, Point from, Point to);
  void remove(int edge, Point from, Point to);

  /// Calls visit(edge) once for every edge whose box shares a cell with `box`.
  template <typename Visit>
  void query(const exact::Box& box, Visit&& visit) const;

  /// Calls visit(edge) for edges in the row of cells right of `p`, level by level, until one column of cells after
  /// the first in which visit returned true; that is where the nearest hit of a ray is known.
  template <typename Visit>
  void walk_right(Point p, Visit&& visit) const;

 private:
  static constexpr int kBaseShift = 30;  ///< Finest cell: 2^30 grid units = 1 m.
  static constexpr int kSkipShift = 4;   ///< A skip cell covers 16 x 16 cells of the layer below it.
  static constexpr int kSkips = 3;

  struct CellRange {
    std::int64_t x0, x1, y0, y1;
    std::int64_t count() const { return (x1 - x0 + 1) * (y1 - y0 + 1); }
  };
  struct Entry {
    int edge;
    int next;
    CellRange range;
  };
  struct Cell {
    std::uint64_t key = 0;  ///< 0: free.
    int head = -1;          ///< First entry, or in skip layers the number of used cells below.
    int count = 0;
  };

  /// Open addressing with linear probing; removal closes the gap, so a table never fills with dead cells.
  class Table {
   public:
    const Cell* find(std::int64_t x, std::int64_t y) const;
    Cell& at(std::int64_t x, std::int64_t y);
    void erase(std::int64_t x, std::int64_t y);
    std::size_t used() const { return used_; }
    const std::vector<Cell>& cells() const { return cells_; }

   private:
    std::size_t slot(std::uint64_t key) const;
    void grow();
    std::vector<Cell> cells_;
    std::size_t used_ = 0;
  };

  /// One size of cell and the layers that say where it is empty.
  struct Level {
    Table cells;
    Table skips[kSkips];
    std::int64_t low_x = 0, high_x = -1;  ///< Columns ever used.
    void mark_used(std::int64_t x, std::int64_t y);
    void mark_free(std::int64_t x, std::int64_t y);
    /// First column >= x whose cell may be in use in row y.
    std::int64_t skip_empty(std::int64_t x, std::int64_t y) const;
  };

  static int level_of(Point from, Point to);
  static CellRange range_of(const exact::Box& box, int level);
  template <typename Visit>
  void visit_cell(const Cell& cell, const CellRange& asked, std::int64_t x, std::int64_t y, Visit& visit) const;

  std::vector<Level> levels_;
  std::vector<Entry> entries_;
  int free_entry_ = -1;

  friend struct EdgeIndexKeys;
};

/// Cells as table keys; column and row have 16 bits at the finest level, 31 are kept.
struct EdgeIndexKeys {
  static constexpr std::int64_t kOffset = std::int64_t{1} << 30;
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return (static_cast<std::uint64_t>(x + kOffset) << 32) | static_cast<std::uint64_t>(y + kOffset);
  }
  static std::int64_t x(std::uint64_t key) { return static_cast<std::int64_t>(key >> 32) - kOffset; }
  static std::int64_t y(std::uint64_t key) { return static_cast<std::int64_t>(key & 0xffffffffU) - kOffset; }
};

template <typename Visit>
void EdgeIndex::visit_cell(const Cell& cell, const CellRange& asked, std::int64_t x, std::int64_t y,
                           Visit& visit) const {
  for (int i = cell.head; i >= 0; i = entries_[i].next) {
    const CellRange& range = entries_[i].range;
    // Of the cells that edge and query share, only the first reports it.
    if (x == std::max(range.x0, asked.x0) && y == std::max(range.y0, asked.y0)) visit(entries_[i].edge);
  }
}

template <typename Visit>
void EdgeIndex::query(const exact::Box& box, Visit&& visit) const {
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const Table& table = levels_[k].cells;
    if (table.used() == 0) continue;
    const CellRange asked = range_of(box, static_cast<int>(k));
    if (asked.count() > static_cast<std::int64_t>(table.cells().size())) {
      for (const Cell& cell : table.cells()) {
        if (cell.key == 0) continue;
        const std::int64_t x = EdgeIndexKeys::x(cell.key);
        const std::int64_t y = EdgeIndexKeys::y(cell.key);
        if (x < asked.x0 || x > asked.x1 || y < asked.y0 || y > asked.y1) continue;
        visit_cell(cell, asked, x, y, visit);
      }
      continue;
    }
    for (std::int64_t y = asked.y0; y <= asked.y1; ++y) {
      for (std::int64_t x = asked.x0; x <= asked.x1; ++x) {
        if (const Cell* cell = table.find(x, y)) visit_cell(*cell, asked, x, y, visit);
      }
    }
  }
}

template <typename Visit>
void EdgeIndex::walk_right(Point p, Visit&& visit) const {
  for (int k = static_cast<int>(levels_.size()) - 1; k >= 0; --k) {
    const Level& level = levels_[k];
    if (level.cells.used() == 0) continue;
    const std::int64_t y = p.y >> (kBaseShift + k);
    std::int64_t last = level.high_x;
    bool hit = false;
    for (std::int64_t x = std::max(level.low_x, p.x >> (kBaseShift + k)); x <= last; ++x) {
      x = level.skip_empty(x, y);
      if (x > last) break;
      const Cell* cell = level.cells.find(x, y);
      if (cell == nullptr) continue;
      bool here = false;
      for (int i = cell->head; i >= 0; i = entries_[i].next) here |= visit(entries_[i].edge);
      if (here && !hit) {
        hit = true;
        last = std::min(last, x + 1);
      }
    }
  }
}

}  // namespace brash::geometry
