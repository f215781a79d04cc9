#include "runtime/smooth/banded.h"

#include <algorithm>

namespace arelem::smooth {

namespace {
constexpr std::size_t coordinates = 3;
}  // namespace

BandedSystem::BandedSystem(std::size_t points, bool closed)
    : rows_(coordinates * points),
      closed_(closed),
      isDense_(closed && points < densePoints),
      inner_(closed && !isDense_ ? rows_ - border : rows_) {
  clear();
}

void BandedSystem::clear() {
  if (isDense_) {
    dense_ =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows_), static_cast<Eigen::Index>(rows_));
  } else {
    entries_.assign(rows_, {});
  }
}

void BandedSystem::add(std::size_t i, std::size_t j, double value) {
  if (isDense_) {
    const auto r = static_cast<Eigen::Index>(i);
    const auto c = static_cast<Eigen::Index>(j);
    dense_(r, c) += value;
    if (i != j) {
      dense_(c, r) += value;
    }
    return;
  }
  // The pair is kept at the row from which the other is at most a band ahead.
  const std::size_t ahead = j >= i ? j - i : j + rows_ - i;
  if (ahead <= band) {
    entries_[i][ahead] += value;
  } else {
    entries_[j][i >= j ? i - j : i + rows_ - j] += value;
  }
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
    const double pivot = row[0];
    // What row i takes from the rows below it, then the row itself becomes a column of L.
    for (std::size_t k = 1; k <= band && i + k < inner_; ++k) {
      const double share = row[k] / pivot;
      for (std::size_t j = k; j <= band; ++j) {
        factor_[i + k][j - k] -= share * row[j];
      }
    }
    for (std::size_t k = 1; k <= band; ++k) {
      row[k] /= pivot;
    }
  }
}

template <class Row>
void BandedSystem::solveBand(std::vector<Row>& x) const {
  for (std::size_t i = 0; i < inner_; ++i) {
    const std::size_t most = std::min(band, inner_ - 1 - i);
    for (std::size_t k = 1; k <= most; ++k) {
      x[i + k] -= factor_[i][k] * x[i];
    }
  }
  for (std::size_t i = inner_; i-- > 0;) {
    x[i] /= factor_[i][0];
    const std::size_t most = std::min(band, inner_ - 1 - i);
    for (std::size_t k = 1; k <= most; ++k) {
      x[i] -= factor_[i][k] * x[i + k];
    }
  }
}

/// [B C; C' D]: Y = B^-1 C is kept, and the inverse of D - C' Y.
void BandedSystem::factorBorder() {
  std::vector<BorderColumn> c(inner_, BorderColumn::Zero());
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
  borderColumns_ = c;
  solveBand(borderColumns_);
  for (std::size_t i = 0; i < inner_; ++i) {
    if (!c[i].isZero(0.0)) {
      d -= c[i] * borderColumns_[i].transpose();
    }
  }
  borderInverse_ = d.inverse();
}

void BandedSystem::solve(std::vector<double>& x) const {
  if (isDense_) {
    Eigen::Map<Eigen::VectorXd> right(x.data(), static_cast<Eigen::Index>(rows_));
    right = denseFactor_.solve(right).eval();
    return;
  }
  if (!closed_) {
    solveBand(x);
    return;
  }
  // The right side of the border, less C' B^-1 f.
  BorderColumn rest = Eigen::Map<BorderColumn>(&x[inner_]);
  for (std::size_t i = 0; i < inner_; ++i) {
    rest -= borderColumns_[i] * x[i];
  }
  solveBand(x);
  const BorderColumn last = borderInverse_ * rest;
  for (std::size_t i = 0; i < inner_; ++i) {
    x[i] -= borderColumns_[i].dot(last);
  }
  Eigen::Map<BorderColumn> end(&x[inner_]);
  end = last;
}

}  // namespace arelem::smooth
