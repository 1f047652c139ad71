#pragma once

#include <vector>

#include <Eigen/Dense>

/// j >= 0 with u = A j + b >= 0 and j u = 0 in each row. A  symmetric, positive definite
inline Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b)
{
    const int n = static_cast<int>(b.size());
    const double slack = 1e-12 * (1.0 + b.cwiseAbs().maxCoeff());
    for (int guess = 0; guess < (1 << n); ++guess) {
        std::vector<int> bear;
        for (int k = 0; k < n; ++k)
            if (((guess >> k) & 1) != 0) bear.push_back(k);
        const int count = static_cast<int>(bear.size());

        // Those that bear don't part: a system of their rows and columns alone
        Eigen::VectorXd j = Eigen::VectorXd::Zero(n);
        if (count > 0) {
            Eigen::MatrixXd part(count, count);
            Eigen::VectorXd wanted(count);
            for (int r = 0; r < count; ++r) {
                wanted(r) = -b(bear[r]);
                for (int c = 0; c < count; ++c) part(r, c) = A(bear[r], bear[c]);
            }
            const Eigen::VectorXd found = part.ldlt().solve(wanted);
            for (int r = 0; r < count; ++r) j(bear[r]) = found(r);
        }
        const Eigen::VectorXd u = A * j + b;
        if (j.minCoeff() >= -slack && u.minCoeff() >= -slack) return j;
    }
    return Eigen::VectorXd::Zero(n);
}
