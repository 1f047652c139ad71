#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("two boxes bear one weight and two")
{
    Eigen::MatrixXd A(2, 2);
    A << 1, -1, -1, 2;              // the point on the floor, the point between, for boxes of 1 kg
    const Eigen::Vector2d b(-1, 0); // both fall, and don't approach each other
    const Eigen::VectorXd j = solve(A, b);
    CHECK(j(0) == doctest::Approx(2.0));
    CHECK(j(1) == doctest::Approx(1.0));
}

TEST_CASE("each contact bears or parts")
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int k = 0; k < 200; ++k) {
        const int n = 1 + k % 7;
        Eigen::MatrixXd root(n, n);
        Eigen::VectorXd b(n);
        for (int r = 0; r < n; ++r) {
            b(r) = any(random);
            for (int c = 0; c < n; ++c) root(r, c) = any(random);
        }
        const Eigen::MatrixXd A = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
        const Eigen::VectorXd j = solve(A, b);
        const Eigen::VectorXd u = A * j + b;
        REQUIRE(j.size() == n);
        CHECK(j.minCoeff() >= -1e-9);
        CHECK(u.minCoeff() >= -1e-9);
        CHECK(std::abs(j.dot(u)) < 1e-8);
    }
}
