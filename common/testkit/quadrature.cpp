#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/testkit/statistics.hpp"

namespace lt {

namespace {

using Function = std::function<double(double)>;

// Nodes and weights of Gauss (7 points) and Kronrod (15 points) on [-1, 1], positive half: every
// second node is Gauss' (QUADPACK, Piessens et al. 1983, routine qk15).
constexpr std::array<double, 7> nodes = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144838258730, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245};
constexpr std::array<double, 7> kronrod_weights = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649};
constexpr std::array<double, 3> gauss_weights = {0.129484966168869693270611432679082,
                                                 0.279705391489276667901467771423780,
                                                 0.381830050505118944950369775488975};
constexpr double kronrod_middle_weight = 0.209482141084727828012999174891714;
constexpr double gauss_middle_weight = 0.417959183673469387755102040816327;

// Errors smaller than this share of the integral are the rounding of double.
constexpr double rounding = 1e-13;

struct Piece {
  double a, b, integral, error;
  bool operator<(const Piece& other) const { return error < other.error; }
};

// The two rules share their nodes; how far they differ bounds the error of the better one.
Piece gauss_kronrod(const Function& f, double a, double b) {
  const double centre = 0.5 * (a + b);
  const double half = 0.5 * (b - a);
  const double middle = f(centre);
  double kronrod = kronrod_middle_weight * middle;
  double gauss = gauss_middle_weight * middle;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double left = f(centre - half * nodes[i]);
    const double right = f(centre + half * nodes[i]);
    kronrod += kronrod_weights[i] * (left + right);
    if (i % 2 == 1) gauss += gauss_weights[i / 2] * (left + right);
  }
  return {a, b, kronrod * half, std::abs((kronrod - gauss) * half)};
}

// Pieces of the interval; the one with the largest error is in front (a heap).
class Pieces {
 public:
  // Several from the start, so that a narrow peak is not missed between the nodes.
  Pieces(const Function& f, double a, double b) : f_(f) {
    constexpr int count = 8;
    for (int i = 0; i < count; ++i) {
      const double high = i + 1 == count ? b : a + (b - a) * (i + 1) / count;
      add(gauss_kronrod(f_, a + (b - a) * i / count, high));
    }
  }

  [[nodiscard]] double integral() const {
    double sum = 0;
    for (const Piece& piece : heap_)
      sum += piece.integral;
    return sum;
  }

  // False for NaN too: no halving mends it.
  [[nodiscard]] bool is_worse_than(double tolerance) const {
    double error = 0;
    double size = 0;
    for (const Piece& piece : heap_) {
      error += piece.error;
      size += std::abs(piece.integral);
    }
    return error > std::max(tolerance, rounding * size);
  }

  // Halves the worst piece. Returns false if that helped nothing though its integral is known well:
  // then f itself is noisy, for example because it computes in float.
  bool halve_worst() {
    std::pop_heap(heap_.begin(), heap_.end());
    const Piece whole = heap_.back();
    heap_.pop_back();
    const double middle = 0.5 * (whole.a + whole.b);
    const Piece left = gauss_kronrod(f_, whole.a, middle);
    const Piece right = gauss_kronrod(f_, middle, whole.b);
    add(left);
    add(right);
    const double integral = left.integral + right.integral;
    return std::abs(integral - whole.integral) > 1e-5 * std::abs(integral) ||
           left.error + right.error < 0.9 * whole.error;
  }

 private:
  void add(const Piece& piece) {
    heap_.push_back(piece);
    std::push_heap(heap_.begin(), heap_.end());
  }

  const Function& f_;
  std::vector<Piece> heap_;
};

}  // namespace

double integrate(const Function& f, double a, double b, double tolerance) {
  constexpr int most_halvings = 4000;
  constexpr int most_in_vain = 20;
  Pieces pieces(f, a, b);
  int in_vain = 0;
  for (int i = 0; i < most_halvings && in_vain < most_in_vain; ++i) {
    if (!pieces.is_worse_than(tolerance)) break;
    if (!pieces.halve_worst()) ++in_vain;
  }
  return pieces.integral();
}

double integrate_2d(const std::function<double(double, double)>& f, double ax, double bx, double ay,
                    double by, double tolerance) {
  if (ax == bx) return 0;
  // The outer rule sees the inner one's error as noise: keep that well below the outer tolerance.
  const double inner_tolerance = 0.1 * tolerance / std::abs(bx - ax);
  const auto strip = [&](double x) {
    return integrate([&f, x](double y) { return f(x, y); }, ay, by, inner_tolerance);
  };
  return integrate(strip, ax, bx, tolerance);
}

}  // namespace lt
