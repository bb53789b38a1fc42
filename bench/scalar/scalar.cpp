/* The pictures of plane-and-cubes, six-spheres and six-spheres-mirror, drawn by a program that can do nothing else.
 *
 *   scalar SCENE FILE
 *
 * It is what a programmer writes by hand in C++ for these scenes: one thread, one ray at a time, doubles, arrays of plain numbers,
 * no vector instructions asked for, no index. The work is Dioptre's: the same camera and pixel centres (src/Dioptre/Render/View.hs),
 * the same rules for planes, spheres and cubes (src/Dioptre/Geometry), shapes tried in the same order until a shadow ray is
 * blocked, the same light, shadows and mirrors (src/Dioptre/Render/Shade.hs), the same bytes (src/Dioptre/Picture/Byte.hs). What these
 * scenes do not have is left out: transparency, textures, attenuation, coefficients near the ends of the range of doubles.
 *
 * The picture goes to FILE as rows of red, green, blue, alpha, one byte each. It prints how many rays were cast, how many times one was
 * tried on a shape, and the seconds from the first ray to the last byte in memory.
 */

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

/* Vectors, and colours */

struct Vec { double x, y, z; };

static inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline Vec operator-(Vec a) { return {-a.x, -a.y, -a.z}; }
static inline Vec operator*(double k, Vec a) { return {k * a.x, k * a.y, k * a.z}; }
static inline Vec filtered(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
static inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static inline double length(Vec a) { return std::sqrt(dot(a, a)); }
static inline Vec unit(Vec a) { return (1 / length(a)) * a; }  // one division where Dioptre's rule has three

/* Tolerances (src/Dioptre/Math/Tolerance.hs) */

static const double smallestParameter = 1e-8;    // nearer, a ray is still on the surface that it left
static const double parallelSine = 0x1p-50;      // a smaller angle with a plane is none
static const double infinity = std::numeric_limits<double>::infinity();

/* The scenes, as numbers. Each table has the lines of its scene.txt in their order. */

struct Camera { Vec position, lookAt, up; double angle, nearPlane, farPlane; };
struct PlaneText { Vec position, normal; };
struct SphereText { Vec centre; double radius; };
struct CubeText { Vec centre; double size; };
struct MaterialText { Vec colour; double ka, kd, ks, shininess, kr; };  // plasticity 1: highlights are white
struct LightText { bool isFar; Vec vector, colour; };                   // the way it travels, or where it is

struct SceneText {
  const char *name;
  int size;           // of the picture, in pixels: it is square
  bool lit;           // Blinn's light, or none
  int depth;          // 1 for no mirrors, 2 for one reflection, ...
  Vec ambient;
  Camera camera;
  std::vector<PlaneText> planes;
  std::vector<CubeText> cubes;
  std::vector<SphereText> spheres;
  std::vector<LightText> lights;
  std::vector<MaterialText> materials;  // of planes, cubes, spheres, in this order
};

static const Camera cubesCamera = {{-5, 0, 2}, {0, 0, 0}, {0, 0, 1}, 65, 0.1, 100};
static const Camera spheresCamera = {{-7, 0, 3}, {0, 0, 0.8}, {0, 0, 1}, 50, 0.1, 10000};
static const std::vector<PlaneText> ground = {{{0, 0, 0}, {0, 0, 1}}};
static const std::vector<CubeText> threeCubes = {{{0, 0, 0}, 1}, {{0, 2, 2}, 1}, {{0, -2, 1}, 1}};
static const std::vector<SphereText> sixSpheres = {{{0, 0, 1}, 1},        {{-1.5, -1.8, 0.6}, 0.6}, {{-1.5, 1.8, 0.6}, 0.6},
                                                   {{1.5, -2.8, 0.9}, 0.9}, {{1.5, 2.8, 0.9}, 0.9},   {{-2.8, 0, 0.4}, 0.4}};
static const std::vector<LightText> twoLights = {{false, {-4, -5, 6}, {0.6, 0.6, 0.6}}, {true, {1, -1, -2}, {0.4, 0.4, 0.4}}};
static const std::vector<MaterialText> paints = {{{0.4, 0.4, 0.4}, 0, 0.4, 0, 0, 0},
                                                 {{0, 0, 1}, 0, 0.6, 0, 0, 0},
                                                 {{0, 1, 0}, 0, 0.6, 0, 0, 0},
                                                 {{1, 0, 0}, 0, 0.6, 0, 0, 0}};

static std::vector<MaterialText> glossy(double kr) {
  std::vector<MaterialText> all;
  for (Vec colour : {Vec{0.6, 0.6, 0.6}, Vec{0.9, 0.2, 0.2}, Vec{0.2, 0.8, 0.3}, Vec{0.2, 0.4, 0.9}, Vec{0.9, 0.7, 0.2}, Vec{0.7, 0.3, 0.8},
                     Vec{0.3, 0.8, 0.8}})
    all.push_back({colour, 0.1, 0.7, 0.4, 50, kr});
  return all;
}

static const SceneText sceneTexts[] = {
    {"plane-and-cubes", 2000, false, 1, {0, 0, 0}, cubesCamera, ground, threeCubes, {}, {}, paints},
    {"six-spheres", 2000, true, 1, {1, 1, 1}, spheresCamera, ground, {}, sixSpheres, twoLights, glossy(0)},
    {"six-spheres-mirror", 2000, true, 4, {1, 1, 1}, spheresCamera, ground, {}, sixSpheres, twoLights, glossy(0.3)},
};

/* The same made ready for many rays: unit normals, squared radii, faces, colours times their coefficients */

struct Plane { Vec position, normal; };
struct Sphere { Vec centre; double radiusSquared; };
struct Cube { Vec low, high; };
struct Material { Vec ambient, diffuse, specular; int shininess; double kr; unsigned char unlit[4]; };
struct Light { bool isFar; Vec vector, colour; };

struct Scene {
  bool lit;
  int depth;
  double farPlane;
  std::vector<Plane> planes;
  std::vector<Cube> cubes;
  std::vector<Sphere> spheres;
  std::vector<Light> lights;
  std::vector<Material> materials;
};

/* The direction need not be unit: a reflected one is so only to rounding. Its squared length is kept for spheres and planes. */
struct Ray {
  Vec origin, direction;
  double quadrance;
  Ray(Vec o, Vec d) : origin(o), direction(d), quadrance(dot(d, d)) {}
};

/* What was done, to be compared with what Dioptre says of itself */
struct Work { long rays = 0, tests = 0; };

/* A channel as a byte: rounded half up after a product in single precision; brighter than 1 is 1. */
static inline unsigned char level(double c) {
  return c >= 1 ? 255 : c > 0 ? (unsigned char)((double)((float)c * 255.0f) + 0.5) : 0;
}

static inline void put(unsigned char *pixel, Vec colour) {
  pixel[0] = level(colour.x), pixel[1] = level(colour.y), pixel[2] = level(colour.z), pixel[3] = 255;
}

static Scene prepared(const SceneText &text) {
  Scene s;
  s.lit = text.lit, s.depth = text.depth, s.farPlane = text.camera.farPlane;
  for (const PlaneText &p : text.planes) s.planes.push_back({p.position, unit(p.normal)});
  for (const CubeText &c : text.cubes) {
    Vec half = 0.5 * Vec{c.size, c.size, c.size};
    s.cubes.push_back({c.centre - half, c.centre + half});
  }
  for (const SphereText &b : text.spheres) s.spheres.push_back({b.centre, b.radius * b.radius});
  for (const LightText &l : text.lights) s.lights.push_back({l.isFar, l.isFar ? unit(l.vector) : l.vector, l.colour});
  for (const MaterialText &m : text.materials) {
    Vec diffuse = m.kd * m.colour;
    Material made = {filtered(text.ambient, m.ka * m.colour), diffuse, {m.ks, m.ks, m.ks}, (int)m.shininess, m.kr, {}};
    put(made.unlit, diffuse);
    s.materials.push_back(made);
  }
  return s;
}

/* Where a ray meets a shape first, above smallestParameter and below a bound; the bound itself if nowhere */

/* <n, d> t + <n, o - P> = 0 */
static inline double nearest(const Plane &p, const Ray &r, double bound) {
  double a = dot(p.normal, r.direction);
  if (!(a * a > parallelSine * parallelSine * r.quadrance)) return bound;
  double t = -(dot(p.normal, r.origin - p.position) / a);
  return t > smallestParameter && t < bound ? t : bound;
}

/* What rounding took from b b - 4 a c, put back (Kahan): for lines that nearly touch the sphere. fma gives each product's error exactly. */
static __attribute__((noinline)) double refined(double a, double b, double c) {
  double u = b * b, v = (4 * a) * c;
  return (u - v) + (std::fma(b, b, -u) - std::fma(4 * a, c, -v));
}

/* a t^2 + b t + c = 0, solved so that nothing cancels: with p = (b -+ sqrt D) / 2, of b's sign, the roots are -c / p and -p / a.
 * -c / p is the one that is nearer to zero. If b >= 0, -p / a is not ahead; if b < 0 it is, and not before -c / p. */
static inline double nearest(const Sphere &s, const Ray &r, double bound) {
  Vec w = r.origin - s.centre;
  double a = r.quadrance, b = 2 * dot(w, r.direction), c = dot(w, w) - s.radiusSquared;
  double u = b * b, v = (4 * a) * c, d = u - v;
  if (d < 0) return bound;             // the line misses the sphere: most do
  if (b >= 0 && c > 0) return bound;   // the sphere is behind
  if (!(d > 0.25 * (u + std::fabs(v)))) {
    d = refined(a, b, c);
    if (!(d >= 0)) return bound;
  }
  double p = 0.5 * (b < 0 ? b - std::sqrt(d) : b + std::sqrt(d));
  double t = -(c / p);
  if (!(t > smallestParameter) && b < 0) t = -(p / a);
  return t > smallestParameter && t < bound ? t : bound;
}

static inline double larger(double a, double b) { return a > b ? a : b; }
static inline double smaller(double a, double b) { return a < b ? a : b; }

/* The line is in all three slabs from the last entry to the first exit. A ray along an axis gives infinities here, which is right
 * unless it lies in a face; none does. The inverse of the direction is a ray's, computed once for all cubes. */
static inline double nearest(const Cube &c, const Ray &r, Vec inverse, double bound) {
  double z1 = (c.low.z - r.origin.z) * inverse.z, z2 = (c.high.z - r.origin.z) * inverse.z;
  double y1 = (c.low.y - r.origin.y) * inverse.y, y2 = (c.high.y - r.origin.y) * inverse.y;
  double enter = larger(smaller(z1, z2), smaller(y1, y2)), leave = smaller(larger(z1, z2), larger(y1, y2));
  if (enter > leave) return bound;     // most lines miss in two slabs already
  double x1 = (c.low.x - r.origin.x) * inverse.x, x2 = (c.high.x - r.origin.x) * inverse.x;
  enter = larger(enter, smaller(x1, x2)), leave = smaller(leave, larger(x1, x2));
  if (!(enter <= leave)) return bound;
  double t = enter > smallestParameter ? enter : leave;
  return t > smallestParameter && t < bound ? t : bound;
}

static inline Vec inverse(Vec d) { return {1 / d.x, 1 / d.y, 1 / d.z}; }

/* The number of the shape that a ray meets first, and where: nearer than t; -1 if none */
static inline int closest(const Scene &s, const Ray &r, double &t, Work &work) {
  int number = 0, found = -1;
  auto offer = [&](double hit) {
    if (hit < t) t = hit, found = number;
    number++;
  };
  for (const Plane &p : s.planes) offer(nearest(p, r, t));
  if (!s.cubes.empty()) {
    Vec inverted = inverse(r.direction);
    for (const Cube &c : s.cubes) offer(nearest(c, r, inverted, t));
  }
  for (const Sphere &b : s.spheres) offer(nearest(b, r, t));
  work.rays++, work.tests += number;
  return found;
}

/* Whether anything stands in a ray's way, nearer than a bound: no farther than the first thing that does. The lit scenes have no cubes. */
static inline bool blocked(const Scene &s, const Ray &r, double bound, Work &work) {
  work.rays++;
  for (const Sphere &b : s.spheres) {
    work.tests++;
    if (nearest(b, r, bound) < bound) return true;
  }
  for (const Plane &p : s.planes) {
    work.tests++;
    if (nearest(p, r, bound) < bound) return true;
  }
  return false;
}

/* x^n by squaring */
static inline double power(double x, int n) {
  double result = 1;
  for (; n > 0; n /= 2, x *= x)
    if (n % 2) result *= x;
  return result;
}

/* The light that a surface sends back along a ray: ambient, then of each light that reaches it Lambert's term and Blinn's highlight.
 * n is turned against v, the direction of the ray. */
static inline Vec lighting(const Scene &s, const Material &m, Vec p, Vec n, Vec v, Work &work) {
  Vec sum = m.ambient;
  for (const Light &l : s.lights) {
    Vec d = l.vector;          // the way the light travels
    double distance = infinity;
    if (!l.isFar) {
      d = p - l.vector;
      distance = length(d);
      d = (1 / distance) * d;
    }
    double facing = -dot(n, d);
    if (facing <= 0 || blocked(s, Ray(p, -d), distance, work)) continue;
    sum = sum + facing * filtered(l.colour, m.diffuse);
    Vec between = -v - d;
    double glance = dot(n, unit(between));
    if (glance >= 0) sum = sum + power(glance, m.shininess) * filtered(l.colour, m.specular);
  }
  return sum;
}

/* What a ray sees: the light of each surface that it meets from mirror to mirror, weighted by what the mirrors before it reflect */
static inline Vec look(const Scene &s, Ray r, Work &work) {
  Vec total = {0, 0, 0};
  double weight = 1;
  for (int depth = 1;; depth++) {
    double t = s.farPlane;
    int found = closest(s, r, t, work);
    if (found < 0) return total;
    const Material &m = s.materials[found];
    Vec p = r.origin + t * r.direction;
    int planes = (int)s.planes.size();
    Vec n = found < planes ? s.planes[found].normal : unit(p - s.spheres[found - planes].centre);
    if (!(dot(r.direction, n) < 0)) n = -n;
    total = total + weight * lighting(s, m, p, n, r.direction, work);
    if (depth >= s.depth || m.kr == 0) return total;
    weight *= m.kr;
    r = Ray(p, r.direction - (2 * dot(r.direction, n)) * n);
  }
}

static void fail(const char *text) {
  std::fprintf(stderr, "scalar: %s\n", text);
  std::exit(1);
}

int main(int count, char **words) {
  if (count != 3) fail("usage: scalar SCENE FILE");
  const SceneText *text = nullptr;
  for (const SceneText &one : sceneTexts)
    if (!std::strcmp(one.name, words[1])) text = &one;
  if (!text) fail("no such scene");
  const Scene s = prepared(*text);
  const Camera &camera = text->camera;
  const int size = text->size;
  const size_t bytes = 4 * (size_t)size * size;
  Work work;

  auto start = std::chrono::steady_clock::now();
  std::unique_ptr<unsigned char[]> picture(new unsigned char[bytes]);  // its pages are first touched below, as Dioptre's are
  /* The viewport stands on the near plane; u1 and u2 are one pixel to the right and one down. Rays start there. */
  Vec front = unit(camera.lookAt - camera.position);
  Vec right = unit(cross(front, camera.up)), down = unit(cross(front, right));
  double pixel = 2 * camera.nearPlane * std::tan(camera.angle / 180 * std::acos(-1) / 2) / size;
  Vec u1 = pixel * right, u2 = pixel * down;
  Vec corner = camera.position + camera.nearPlane * front - (0.5 * size) * (u1 + u2);
  unsigned char *out = picture.get();
  for (int row = 0; row < size; row++)
    for (int column = 0; column < size; column++, out += 4) {
      Vec p = corner + (column + 0.5) * u1 + (row + 0.5) * u2;
      Ray r(p, unit(p - camera.position));
      if (s.lit) {
        put(out, look(s, r, work));
      } else {
        double t = s.farPlane;
        int found = closest(s, r, t, work);
        static const unsigned char black[4] = {0, 0, 0, 255};
        std::memcpy(out, found < 0 ? black : s.materials[found].unlit, 4);
      }
    }
  std::chrono::duration<double> tracing = std::chrono::steady_clock::now() - start;

  FILE *file = std::fopen(words[2], "wb");
  if (!file || std::fwrite(picture.get(), 1, bytes, file) != bytes || std::fclose(file)) fail("the picture cannot be written");
  std::printf("%ld rays, %ld intersection tests, tracing %.4f s\n", work.rays, work.tests, tracing.count());
  return 0;
}
