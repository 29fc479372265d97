// SPDX-License-Identifier: GPL-3.0-or-later
// Decompositions of matrices of any size, by Eigen, compiled in one place: each costs every file
// that instantiates it up to twelve seconds.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>

namespace dewpoint::geometry {

/// The x for which |matrix x - right| is least, one column for each column of `right`; by QR with
/// column pivoting. Where the matrix does not determine x, a basic solution.
Eigen::MatrixXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);
Eigen::VectorXd leastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);

/// Eigenvalues of a symmetric matrix in rising order, and their unit vectors as columns.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
  bool converged = false;
};

/// Reads the lower triangle only.
SymmetricEigen symmetricEigen(const Eigen::MatrixXd& matrix);

/// The x of matrix x = right for a positive or negative semidefinite matrix, by LDLT.
Eigen::MatrixXd solveSymmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The inverse of a symmetric positive definite matrix, by Cholesky's method; nothing for another.
std::optional<Eigen::MatrixXd> inversePositive(const Eigen::MatrixXd& matrix);

/// A singular value decomposition by Jacobi rotations.
class SingularValues {
public:
  /// What is computed beside the values. `Thin` and `Full` allow solve(), `Full` gives all columns
  /// of V, those of the null space last.
  enum class Vectors { None, Thin, Full };

  SingularValues(const Eigen::MatrixXd& matrix, Vectors vectors);
  SingularValues(const SingularValues&) = delete;
  SingularValues& operator=(const SingularValues&) = delete;
  ~SingularValues();

  /// In falling order, as many as the shorter side of the matrix has.
  const Eigen::VectorXd& values() const;
  const Eigen::MatrixXd& matrixV() const;
  /// The shortest of all x for which |matrix x - right| is least.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

private:
  struct Decomposition;
  std::unique_ptr<Decomposition> decomposition_;
};

} // namespace dewpoint::geometry
