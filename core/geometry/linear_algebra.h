// SPDX-License-Identifier: GPL-3.0-or-later
// Eigen's decompositions of matrices of any size. These decompositions are compiled in one place,
// because each would add up to twelve seconds to the compilation of every file that uses it.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>

namespace dewpoint::geometry {

/// Returns the least-squares solution x of `matrix` * x = `right`. x has one column for each column
/// of `right`. Method: QR decomposition with column pivoting. If several x are equally good, the
/// result is one of them, not necessarily the x with the smallest norm.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Eigenvalues of a symmetric matrix in ascending order, and unit eigenvectors as columns.
struct SymmetricEigen {
  Eigen::VectorXd eigenvalues;
  Eigen::MatrixXd eigenvectors;
  bool hasConverged = false;
};

/// Computes the eigendecomposition of a symmetric matrix. Only the lower triangle is read.
/// `hasConverged` is false in the result if the iteration failed.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix);

/// Returns the solution x of `matrix` * x = `right` for a positive or negative semidefinite matrix.
/// Method: LDLT.
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// Returns the inverse of a symmetric positive definite matrix, by Cholesky decomposition. Returns
/// nothing for any other matrix.
std::optional<Eigen::MatrixXd> inversePositiveDefinite(const Eigen::MatrixXd& matrix);

/// Returns the inverse of a square matrix, by LU decomposition with partial pivoting. If the matrix
/// is exactly singular, the result has elements that are not finite.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix);

/// LDLT decomposition of a symmetric matrix, for solving equations with several right sides. Only
/// the lower triangle of the matrix is read.
class SymmetricFactorization {
public:
  explicit SymmetricFactorization(const Eigen::MatrixXd& matrix);
  SymmetricFactorization(const SymmetricFactorization&) = delete;
  SymmetricFactorization& operator=(const SymmetricFactorization&) = delete;
  ~SymmetricFactorization();

  /// Returns whether the decomposition succeeded and the matrix is positive semidefinite.
  bool isPositiveDefinite() const;
  /// Returns the solution x of `matrix` * x = `right`, with one column for each column of `right`.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

private:
  struct Decomposition;
  std::unique_ptr<Decomposition> decomposition_;
};

/// Singular value decomposition of a matrix, computed by Jacobi rotations.
class SingularValues {
public:
  /// Which singular vectors to compute. solve() requires `Thin` or `Full`. With `Full`, matrixV()
  /// is square, and its last columns span the null space.
  enum class Vectors { None, Thin, Full };

  SingularValues(const Eigen::MatrixXd& matrix, Vectors vectors);
  SingularValues(const SingularValues&) = delete;
  SingularValues& operator=(const SingularValues&) = delete;
  ~SingularValues();

  /// Returns the singular values in descending order. There are as many singular values as the
  /// matrix has rows or columns, whichever is fewer.
  const Eigen::VectorXd& values() const;
  /// Returns the right singular vectors as columns.
  const Eigen::MatrixXd& matrixV() const;
  /// Returns the least-squares solution x of `matrix` * x = `right`, where `matrix` is the
  /// decomposed matrix. If there are several solutions, returns the solution with the smallest
  /// norm.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

private:
  struct Decomposition;
  std::unique_ptr<Decomposition> decomposition_;
};

} // namespace dewpoint::geometry
