/* The primary rays of a picture of an OBJ file's triangles, with Embree: one ray at a time, one thread.
 *
 *   primary FILE.obj SIZE FAR NEAR ANGLE  EYE(x y z) LOOK_AT(x y z) UP(x y z)
 *
 * The rays are those of Dioptre (src/Dioptre/Render/View.hs): through the middle of each of SIZE x SIZE pixels, from the
 * near plane on. Each pixel gets the colour of a material that says kd = (0.3, 0.7, 0.3), or black. It prints
 * the number of triangles and of rays that hit, the seconds that building took, and the seconds that tracing did.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

typedef struct { double x, y, z; } vec;

static vec sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static vec add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static vec times(double k, vec a) { return (vec){k * a.x, k * a.y, k * a.z}; }
static vec cross(vec a, vec b) { return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static vec unit(vec a) { return times(1 / sqrt(a.x * a.x + a.y * a.y + a.z * a.z), a); }

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

static void fail(const char *text) {
  fprintf(stderr, "primary: %s\n", text);
  exit(1);
}

/* A growing array of floats or of indices: both have four bytes. */
typedef struct { void *items; size_t count, room; } list;

static void *more(list *l, size_t n) {
  if (l->count + n > l->room) {
    l->room = 2 * l->room + n;
    l->items = realloc(l->items, 4 * l->room);
    if (!l->items) fail("no memory");
  }
  l->count += n;
  return (char *)l->items + 4 * (l->count - n);
}

static void read_obj(const char *path, list *points, list *corners) {
  FILE *file = fopen(path, "r");
  if (!file) fail("no such file");
  char line[512];
  while (fgets(line, sizeof line, file)) {
    if (line[0] == 'v' && line[1] == ' ') {
      float *p = more(points, 3);
      if (sscanf(line + 2, "%f %f %f", p, p + 1, p + 2) != 3) fail("a vertex without three numbers");
    } else if (line[0] == 'f' && line[1] == ' ') {
      unsigned *c = more(corners, 3);
      char *word = strtok(line + 2, " \n");
      for (int i = 0; i < 3; i++, word = strtok(NULL, " \n")) {
        if (!word) fail("a face without three corners");
        c[i] = strtoul(word, NULL, 10) - 1;
      }
    }
  }
  fclose(file);
}

int main(int count, char **words) {
  if (count != 15) fail("usage: primary FILE.obj SIZE FAR NEAR ANGLE EYE LOOK_AT UP");
  double n[13];
  for (int i = 0; i < 13; i++) n[i] = atof(words[i + 2]);
  int size = (int)n[0];
  double far = n[1], near = n[2], angle = n[3] / 180 * acos(-1);
  vec eye = {n[4], n[5], n[6]}, look_at = {n[7], n[8], n[9]}, up = {n[10], n[11], n[12]};

  list points = {0}, corners = {0};
  read_obj(words[1], &points, &corners);
  size_t triangles = corners.count / 3;

  double start = now();
  RTCDevice device = rtcNewDevice("threads=1");
  if (!device) fail("no device");
  RTCScene scene = rtcNewScene(device);
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float *vertices = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, points.count / 3);
  unsigned *indices = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles);
  if (!vertices || !indices) fail("no buffers");
  memcpy(vertices, points.items, 4 * points.count);
  memcpy(indices, corners.items, 4 * corners.count);
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene, mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene);
  double built = now();

  vec front = unit(sub(look_at, eye));
  vec right = unit(cross(front, up));
  vec down = unit(cross(front, right));
  double pixel = 2 * near * tan(angle / 2) / size;
  vec corner = add(times(near, front), times(-0.5 * size * pixel, add(right, down)));
  unsigned char *picture = calloc(size, 4 * (size_t)size);
  if (!picture) fail("no memory");
  size_t hits = 0;
#if RTC_VERSION_MAJOR < 4
  struct RTCIntersectContext context;
  rtcInitIntersectContext(&context);
#endif
  for (int row = 0; row < size; row++)
    for (int column = 0; column < size; column++) {
      vec through = add(corner, add(times(pixel * (column + 0.5), right), times(pixel * (row + 0.5), down)));
      vec o = add(eye, through), d = unit(through);
      struct RTCRayHit r;
      memset(&r, 0, sizeof r);
      r.ray.org_x = o.x, r.ray.org_y = o.y, r.ray.org_z = o.z;
      r.ray.dir_x = d.x, r.ray.dir_y = d.y, r.ray.dir_z = d.z;
      r.ray.tnear = 1e-8f, r.ray.tfar = far, r.ray.mask = -1;
      r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
      rtcIntersect1(scene, &r, NULL);
#else
      rtcIntersect1(scene, &context, &r);
#endif
      if (r.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        hits++;
        memcpy(picture + 4 * ((size_t)row * size + column), "\115\263\115\377", 4);
      }
    }
  double traced = now();
  printf("%zu triangles, %zu hits, building %.4f s, tracing %.4f s\n", triangles, hits, built - start, traced - built);
  free(picture);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return 0;
}
