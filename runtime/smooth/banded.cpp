#include "runtime/smooth/banded.h"

#include <algorithm>

namespace arelem::smooth {

BandedSystem::BandedSystem(std::size_t points, bool closed)
    : rows_(points),
      closed_(closed),
      isDense_(closed && points < densePoints),
      inner_(closed && !isDense_ ? rows_ - band : rows_) {
  clear();
}

void BandedSystem::clear() {
  if (isDense_) {
    dense_.setZero(static_cast<Eigen::Index>(rows_), static_cast<Eigen::Index>(rows_));
  } else {
    entries_.assign(rows_, {});
  }
}

void BandedSystem::add(std::size_t i, std::size_t ahead, double value) {
  if (!isDense_) {
    entries_[i][ahead] += value;
    return;
  }
  const auto r = static_cast<Eigen::Index>(i);
  const auto c = static_cast<Eigen::Index>((i + ahead) % rows_);
  dense_(r, c) += value;
  if (ahead != 0) {
    dense_(c, r) += value;
  }
}

double BandedSystem::diagonal(std::size_t i) const {
  const auto r = static_cast<Eigen::Index>(i);
  return isDense_ ? dense_(r, r) : entries_[i][0];
}

void BandedSystem::factor() {
  if (isDense_) {
    denseFactor_.compute(dense_);
    return;
  }
  factorBand();
  if (closed_) {
    factorBorder();
  }
}

void BandedSystem::factorBand() {
  factor_.assign(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(inner_));
  for (std::size_t i = 0; i < inner_; ++i) {
    std::array<double, band + 1>& row = factor_[i];
    row[0] = 1.0 / row[0];
    // What row i takes from the rows below it, then the row itself becomes a column of L.
    for (std::size_t k = 1; k <= band && i + k < inner_; ++k) {
      const double share = row[k] * row[0];
      for (std::size_t j = k; j <= band; ++j) {
        factor_[i + k][j - k] -= share * row[j];
      }
    }
    for (std::size_t k = 1; k <= band; ++k) {
      row[k] *= row[0];
    }
  }
}

template <class Row>
void BandedSystem::solveBand(std::vector<Row>& x) const {
  for (std::size_t i = 0; i < inner_; ++i) {
    // The row before last: nothing waits for it but this.
    for (std::size_t k = std::min(band, i); k > 0; --k) {
      x[i] -= factor_[i - k][k] * x[i - k];
    }
  }
  for (std::size_t i = inner_; i-- > 0;) {
    x[i] *= factor_[i][0];
    for (std::size_t k = std::min(band, inner_ - 1 - i); k > 0; --k) {
      x[i] -= factor_[i][k] * x[i + k];
    }
  }
}

/// [B C; C' D]: Y = B^-1 C is kept, and the inverse of D - C' Y.
void BandedSystem::factorBorder() {
  std::vector<BorderRow> c(inner_, BorderRow::Zero());
  Border d = Border::Zero();
  const auto column = [&](std::size_t row) { return static_cast<Eigen::Index>(row - inner_); };
  for (std::size_t i = 0; i < rows_; ++i) {
    for (std::size_t k = 0; k <= band; ++k) {
      const std::size_t j = (i + k) % rows_;
      if (i < inner_ && j >= inner_) {
        c[i](column(j)) += entries_[i][k];
      } else if (i >= inner_ && j < inner_) {
        c[j](column(i)) += entries_[i][k];
      } else if (i >= inner_ && j >= inner_) {
        d(column(i), column(j)) += entries_[i][k];
        if (i != j) {
          d(column(j), column(i)) += entries_[i][k];
        }
      }
    }
  }
  borderRows_ = c;
  solveBand(borderRows_);
  for (std::size_t i = 0; i < inner_; ++i) {
    d -= c[i].transpose() * borderRows_[i];
  }
  borderInverse_ = d.inverse();
}

void BandedSystem::solveDense(std::vector<Vec3>& x) const {
  Eigen::Map<Eigen::Matrix<double, 3, Eigen::Dynamic>> right(x.front().data(), 3,
                                                             static_cast<Eigen::Index>(rows_));
  const Eigen::MatrixXd solution = denseFactor_.solve(right.transpose());
  right = solution.transpose();
}

void BandedSystem::solve(std::vector<Vec3>& x) const {
  if (isDense_) {
    return solveDense(x);
  }
  if (!closed_) {
    return solveBand(x);
  }
  // The right side of the border, less C' B^-1 f.
  Eigen::Matrix<double, band, 3> rest;
  for (std::size_t k = 0; k < band; ++k) {
    rest.row(static_cast<Eigen::Index>(k)) = x[inner_ + k].transpose();
  }
  for (std::size_t i = 0; i < inner_; ++i) {
    rest -= borderRows_[i].transpose() * x[i].transpose();
  }
  solveBand(x);
  const Eigen::Matrix<double, band, 3> last = borderInverse_ * rest;
  for (std::size_t i = 0; i < inner_; ++i) {
    x[i] -= (borderRows_[i] * last).transpose();
  }
  for (std::size_t k = 0; k < band; ++k) {
    x[inner_ + k] = last.row(static_cast<Eigen::Index>(k)).transpose();
  }
}

}  // namespace arelem::smooth
