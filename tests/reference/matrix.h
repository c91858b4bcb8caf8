#pragma once

#include <array>
#include <cstddef>

/// 3 x 3 matrices and what is made of them, in one text for double and for 50 digits.
namespace nacre::reference {

template <typename T>
using Vector = std::array<T, 3>;
template <typename T>
using Matrix = std::array<std::array<T, 3>, 3>;
using Triple = Vector<double>;

template <typename T>
Vector<T> operator*(const Matrix<T>& m, const Vector<T>& v) {
    Vector<T> product{};
    for (std::size_t i = 0; i < 3; ++i) product[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return product;
}

/// By cofactors.
template <typename T>
Matrix<T> inverse(const Matrix<T>& m) {
    Matrix<T> result{};
    T determinant(0);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            result[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
        }
        determinant += m[0][i] * result[i][0];
    }
    for (auto& row : result)
        for (T& element : row) element /= determinant;
    return result;
}

template <typename T>
Vector<T> from_chromaticity(const T& x, const T& y) {
    return {x / y, T(1), (1 - x - y) / y};
}

template <typename T>
Vector<T> d65_white() {
    return from_chromaticity(T(T(3127) / 10000), T(T(3290) / 10000));
}

/// From a white to D65: Lam 1985, as printed in the ICC profile specification, annex E.
template <typename T>
Matrix<T> bradford_to_d65(const Vector<T>& white) {
    constexpr int printed[3][3] = {{8951, 2664, -1614}, {-7502, 17135, 367}, {389, -685, 10296}};
    Matrix<T> cones{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) cones[i][j] = T(T(printed[i][j]) / 10000);
    const Vector<T> from = cones * white, to = cones * d65_white<T>();
    Matrix<T> gained = cones;
    for (std::size_t i = 0; i < 3; ++i)
        for (T& element : gained[i]) element *= to[i] / from[i];
    const Matrix<T> back = inverse(cones);
    Matrix<T> result{};
    for (std::size_t j = 0; j < 3; ++j) {
        const Vector<T> column = back * Vector<T>{gained[0][j], gained[1][j], gained[2][j]};
        for (std::size_t i = 0; i < 3; ++i) result[i][j] = column[i];
    }
    return result;
}

}  // namespace nacre::reference
