#pragma once

#include <Eigen/Dense>

/// j >= 0 with u = A j + b >= 0 and j u = 0 in each row. A  symmetric, positive definite
inline Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b)
{
    (void)A;
    return Eigen::VectorXd::Zero(b.size()); // your code here
}
