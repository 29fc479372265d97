// SPDX-License-Identifier: GPL-3.0-or-later
// Eigen's decompositions of matrices of any size. They are compiled in one place, because each one
// would add up to twelve seconds to the compilation of every file that instantiates it.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>

namespace dewpoint::geometry {

/// Returns the least-squares solution x of `matrix` * x = `right`. It has one column for each
/// column of `right`. Method: QR with column pivoting. If the matrix does not determine x, the
/// result is a basic solution.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Eigenvalues of a symmetric matrix in ascending order, and unit eigenvectors as columns.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
  bool converged = false;
};

/// Computes the eigendecomposition of a symmetric matrix. Only the lower triangle is read.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix);

/// Returns the solution x of `matrix` * x = `right` for a positive or negative semidefinite matrix.
/// Method: LDLT.
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Returns the inverse of a symmetric positive definite matrix, by Cholesky decomposition. Returns
/// nothing for any other matrix.
std::optional<Eigen::MatrixXd> inversePositiveDefinite(const Eigen::MatrixXd& matrix);

/// Returns the inverse of a square matrix, by LU decomposition with partial pivoting. Elements are
/// not finite if the matrix is singular.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// The LDLT decomposition of a symmetric matrix, for several right sides. Only the lower triangle
/// of the matrix is read.
class SymmetricFactor {
public:
  explicit SymmetricFactor(const Eigen::MatrixXd& matrix);
  SymmetricFactor(const SymmetricFactor&) = delete;
  SymmetricFactor& operator=(const SymmetricFactor&) = delete;
  ~SymmetricFactor();

  /// Returns whether the decomposition succeeded and the matrix is positive semidefinite.
  bool isPositive() const;
  /// Returns the solution x of `matrix` * x = `right`, with one column for each column of `right`.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
  struct Decomposition;
  std::unique_ptr<Decomposition> decomposition_;
};

/// Singular value decomposition by Jacobi rotations.
class SingularValues {
public:
  /// Singular vectors to compute. solve() requires `Thin` or `Full`. With `Full`, matrixV() has all
  /// columns, with those of the null space last.
  enum class Vectors { None, Thin, Full };

  SingularValues(const Eigen::MatrixXd& matrix, Vectors vectors);
  SingularValues(const SingularValues&) = delete;
  SingularValues& operator=(const SingularValues&) = delete;
  ~SingularValues();

  /// Returns the singular values in descending order. Their number is the shorter side of the
  /// matrix.
  const Eigen::VectorXd& values() const;
  /// Returns the right singular vectors as columns.
  const Eigen::MatrixXd& matrixV() const;
  /// Returns the least-squares solution x of `matrix` * x = `right`; if there are several, the one
  /// with the smallest norm. `matrix` is the decomposed matrix.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

private:
  struct Decomposition;
  std::unique_ptr<Decomposition> decomposition_;
};

} // namespace dewpoint::geometry
