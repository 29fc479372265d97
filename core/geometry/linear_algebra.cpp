// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/linear_algebra.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace dewpoint::geometry {
namespace {

unsigned int options(SingularValues::Vectors vectors) {
  switch (vectors) {
  case SingularValues::Vectors::Thin:
    return Eigen::ComputeThinU | Eigen::ComputeThinV;
  case SingularValues::Vectors::Full:
    return Eigen::ComputeFullU | Eigen::ComputeFullV;
  case SingularValues::Vectors::None:
    break;
  }
  return 0;
}

} // namespace

Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

Eigen::VectorXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors(), solver.info() == Eigen::Success};
}

Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
  return matrix.ldlt().solve(right);
}

std::optional<Eigen::MatrixXd> inversePositiveDefinite(const Eigen::MatrixXd& matrix) {
  const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  if (factor.info() != Eigen::Success) {
    return std::nullopt;
  }
  return factor.solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
  return matrix.inverse();
}

struct SymmetricFactorization::Decomposition {
  explicit Decomposition(const Eigen::MatrixXd& matrix) : ldlt(matrix) {}
  Eigen::LDLT<Eigen::MatrixXd> ldlt;
};

SymmetricFactorization::SymmetricFactorization(const Eigen::MatrixXd& matrix)
    : decomposition_(std::make_unique<Decomposition>(matrix)) {}

SymmetricFactorization::~SymmetricFactorization() = default;

bool SymmetricFactorization::isPositiveDefinite() const {
  return decomposition_->ldlt.info() == Eigen::Success && decomposition_->ldlt.isPositive();
}

Eigen::MatrixXd SymmetricFactorization::solve(const Eigen::MatrixXd& right) const {
  return decomposition_->ldlt.solve(right);
}

struct SingularValues::Decomposition {
  Decomposition(const Eigen::MatrixXd& matrix, unsigned vectors) : svd(matrix, vectors) {}
  Eigen::JacobiSVD<Eigen::MatrixXd> svd;
};

SingularValues::SingularValues(const Eigen::MatrixXd& matrix, Vectors vectors)
    : decomposition_(std::make_unique<Decomposition>(matrix, options(vectors))) {}

SingularValues::~SingularValues() = default;

const Eigen::VectorXd& SingularValues::values() const {
  return decomposition_->svd.singularValues();
}

const Eigen::MatrixXd& SingularValues::matrixV() const {
  return decomposition_->svd.matrixV();
}

Eigen::VectorXd SingularValues::solve(const Eigen::VectorXd& right) const {
  return decomposition_->svd.solve(right);
}

} // namespace dewpoint::geometry
