// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_index.hpp"

#include <bit>

#include "brash/core/contract.hpp"

namespace brash::geometry {

namespace {

std::uint64_t mixed(std::uint64_t key) {
  key *= 0x9e3779b97f4a7c15ULL;
  return key ^ (key >> 32);
}

}  // namespace

std::size_t EdgeIndex::Table::slot(std::uint64_t key) const {
  const std::size_t mask = cells_.size() - 1;
  std::size_t i = mixed(key) & mask;
  while (cells_[i].key != 0 && cells_[i].key != key) i = (i + 1) & mask;
  return i;
}

const EdgeIndex::Cell* EdgeIndex::Table::find(std::int64_t x, std::int64_t y) const {
  if (used_ == 0) return nullptr;
  const Cell& cell = cells_[slot(EdgeIndexKeys::key(x, y))];
  return cell.key == 0 ? nullptr : &cell;
}

EdgeIndex::Cell& EdgeIndex::Table::at(std::int64_t x, std::int64_t y) {
  if (2 * (used_ + 1) > cells_.size()) grow();
  const std::uint64_t key = EdgeIndexKeys::key(x, y);
  Cell& cell = cells_[slot(key)];
  if (cell.key == 0) {
    cell = Cell{key, -1, 0};
    ++used_;
  }
  return cell;
}

void EdgeIndex::Table::erase(std::int64_t x, std::int64_t y) {
  const std::size_t mask = cells_.size() - 1;
  std::size_t hole = slot(EdgeIndexKeys::key(x, y));
  BRASH_EXPECTS(cells_[hole].key != 0, x, y);
  // Move back every later cell of the run that may go into the hole.
  for (std::size_t i = (hole + 1) & mask; cells_[i].key != 0; i = (i + 1) & mask) {
    const std::size_t home = mixed(cells_[i].key) & mask;
    if (((i - home) & mask) < ((i - hole) & mask)) continue;
    cells_[hole] = cells_[i];
    hole = i;
  }
  cells_[hole] = Cell{};
  --used_;
}

void EdgeIndex::Table::grow() {
  std::vector<Cell> old(std::max<std::size_t>(16, cells_.size() * 2));
  old.swap(cells_);
  for (const Cell& cell : old) {
    if (cell.key != 0) cells_[slot(cell.key)] = cell;
  }
}

void EdgeIndex::Level::mark_used(std::int64_t x, std::int64_t y) {
  if (high_x < low_x) low_x = high_x = x;
  low_x = std::min(low_x, x);
  high_x = std::max(high_x, x);
  for (Table& skip : skips) {
    x >>= kSkipShift;
    y >>= kSkipShift;
    if (++skip.at(x, y).count > 1) return;
  }
}

void EdgeIndex::Level::mark_free(std::int64_t x, std::int64_t y) {
  for (Table& skip : skips) {
    x >>= kSkipShift;
    y >>= kSkipShift;
    if (--skip.at(x, y).count > 0) return;
    skip.erase(x, y);
  }
}

std::int64_t EdgeIndex::Level::skip_empty(std::int64_t x, std::int64_t y) const {
  while (x <= high_x) {
    std::int64_t next = x;
    for (int k = kSkips; k > 0 && next == x; --k) {
      const int shift = k * kSkipShift;
      if (skips[k - 1].find(x >> shift, y >> shift) == nullptr) next = ((x >> shift) + 1) << shift;
    }
    if (next == x) return x;
    x = next;
  }
  return x;
}

int EdgeIndex::level_of(Point from, Point to) {
  const std::int64_t extent = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const int bits = std::bit_width(static_cast<std::uint64_t>(extent));
  return std::max(0, bits - kBaseShift);
}

EdgeIndex::CellRange EdgeIndex::range_of(const exact::Box& box, int level) {
  const int shift = kBaseShift + level;
  return {box.low.x >> shift, box.high.x >> shift, box.low.y >> shift, box.high.y >> shift};
}

void EdgeIndex::insert(int edge, Point from, Point to) {
  const int k = level_of(from, to);
  if (static_cast<std::size_t>(k) >= levels_.size()) levels_.resize(k + 1);
  Level& level = levels_[k];
  const CellRange range = range_of(exact::Box::of(from, to), k);
  for (std::int64_t y = range.y0; y <= range.y1; ++y) {
    for (std::int64_t x = range.x0; x <= range.x1; ++x) {
      Cell& cell = level.cells.at(x, y);
      if (cell.count++ == 0) level.mark_used(x, y);
      int entry = free_entry_;
      if (entry >= 0) {
        free_entry_ = entries_[entry].next;
      } else {
        entry = static_cast<int>(entries_.size());
        entries_.emplace_back();
      }
      entries_[entry] = {edge, cell.head, range};
      cell.head = entry;
    }
  }
}

void EdgeIndex::remove(int edge, Point from, Point to) {
  const int k = level_of(from, to);
  Level& level = levels_.at(k);
  const CellRange range = range_of(exact::Box::of(from, to), k);
  for (std::int64_t y = range.y0; y <= range.y1; ++y) {
    for (std::int64_t x = range.x0; x <= range.x1; ++x) {
      Cell& cell = level.cells.at(x, y);
      int* link = &cell.head;
      while (*link >= 0 && entries_[*link].edge != edge) link = &entries_[*link].next;
      BRASH_EXPECTS(*link >= 0, edge, from.x, from.y, to.x, to.y);
      const int entry = *link;
      *link = entries_[entry].next;
      entries_[entry].next = free_entry_;
      free_entry_ = entry;
      if (--cell.count == 0) {
        level.mark_free(x, y);
        level.cells.erase(x, y);
      }
    }
  }
}

}  // namespace brash::geometry
