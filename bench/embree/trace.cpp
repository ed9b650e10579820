// Traces the camera and shadow rays of a scene with Embree, one by one on one thread, and says what a ray takes.
// Build and use: see README.md.

#include <embree3/rtcore.h>
#include <immintrin.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <vector>

struct Vec {
    float x, y, z;
};
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, float s) { return {a.x * s, a.y * s, a.z * s}; }
float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct Input {
    uint32_t side = 0;
    Vec eye, first, column, row;
    std::vector<Vec> lights, corners;
};

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "%s\n", what);
    std::exit(1);
}

void get(std::FILE* file, void* to, size_t bytes) {
    if (std::fread(to, 1, bytes, file) != bytes) fail("the file is too short");
}

Input read(const char* path) {
    std::FILE* file = std::fopen(path, "rb");
    if (!file) fail("cannot open the file");
    uint32_t counts[3];
    get(file, counts, sizeof counts);
    Input input;
    input.side = counts[0];
    for (Vec* v : {&input.eye, &input.first, &input.column, &input.row}) get(file, v, sizeof *v);
    input.lights.resize(counts[1]);
    get(file, input.lights.data(), counts[1] * sizeof(Vec));
    input.corners.resize(size_t{3} * counts[2]);
    get(file, input.corners.data(), input.corners.size() * sizeof(Vec));
    std::fclose(file);
    return input;
}

RTCScene build(RTCDevice device, const Input& input) {
    RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const size_t count = input.corners.size();
    void* points = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec), count);
    std::memcpy(points, input.corners.data(), count * sizeof(Vec));
    auto* index = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), count / 3));
    for (size_t i = 0; i < count; ++i) index[i] = static_cast<uint32_t>(i);
    rtcCommitGeometry(mesh);
    RTCScene scene = rtcNewScene(device);
    rtcAttachGeometry(scene, mesh);
    rtcReleaseGeometry(mesh);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene);
    return scene;
}

RTCRay ray(Vec from, Vec along, float near, float far) {
    RTCRay ray{};
    ray.org_x = from.x, ray.org_y = from.y, ray.org_z = from.z;
    ray.dir_x = along.x, ray.dir_y = along.y, ray.dir_z = along.z;
    ray.tnear = near, ray.tfar = far;
    ray.mask = ~0u;
    return ray;
}

struct Hit {
    Vec point, normal;  // The normal looks towards the eye.
};

// Blocks of 8 × 8 pixels, the order in which brt traces.
std::vector<Hit> camera_rays(RTCScene scene, const Input& input) {
    std::vector<Hit> hits;
    hits.reserve(size_t{input.side} * input.side);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (uint32_t block_y = 0; block_y < input.side; block_y += 8)
        for (uint32_t block_x = 0; block_x < input.side; block_x += 8)
            for (uint32_t y = block_y; y < std::min(block_y + 8, input.side); ++y)
                for (uint32_t x = block_x; x < std::min(block_x + 8, input.side); ++x) {
                    const Vec along = input.first + input.column * float(x) + input.row * float(y);
                    RTCRayHit found{};
                    found.ray = ray(input.eye, along, 0.0f, 1e30f);
                    found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
                    rtcIntersect1(scene, &context, &found);
                    if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
                    const Vec normal{found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z};
                    const float side = dot(normal, along) > 0.0f ? -1.0f : 1.0f;
                    hits.push_back({input.eye + along * found.ray.tfar, normal * side});
                }
    return hits;
}

struct Shadows {
    size_t rays = 0, hidden = 0;
};

// To the lights that the surface does not face away from.
Shadows shadow_rays(RTCScene scene, const Input& input, const std::vector<Hit>& hits) {
    Shadows shadows;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (const Hit& hit : hits)
        for (Vec light : input.lights) {
            const Vec along = light - hit.point;
            if (dot(along, hit.normal) <= 0.0f) continue;
            RTCRay shadow = ray(hit.point, along, 1e-4f, 1.0f);
            rtcOccluded1(scene, &context, &shadow);
            shadows.rays += 1;
            shadows.hidden += shadow.tfar < 0.0f;
        }
    return shadows;
}

// Of processor time: others may use the machine, too.
template <class Work>
double seconds(Work work) {
    const std::clock_t begin = std::clock();
    work();
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

int main(int count, char** arguments) {
    if (count < 2) fail("usage: trace FILE [RUNS]");
    const int runs = count > 2 ? std::max(1, std::atoi(arguments[2])) : 5;
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    const Input input = read(arguments[1]);
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = nullptr;
    const double building = seconds([&] { scene = build(device, input); });
    std::vector<Hit> hits;
    Shadows shadows;
    std::vector<double> camera, shadow;
    for (int i = 0; i < runs; ++i) {
        camera.push_back(seconds([&] { hits = camera_rays(scene, input); }));
        shadow.push_back(seconds([&] { shadows = shadow_rays(scene, input, hits); }));
    }
    const double pixels = double(input.side) * input.side;
    std::printf("triangles %zu, built in %.2f s\n", input.corners.size() / 3, building);
    std::printf("camera rays %.0f, hits %zu: %.1f ns a ray\n", pixels, hits.size(), 1e9 * median(camera) / pixels);
    std::printf("shadow rays %zu, hidden %zu: %.1f ns a ray\n", shadows.rays, shadows.hidden,
                1e9 * median(shadow) / double(std::max<size_t>(shadows.rays, 1)));
    std::printf("together %.1f ns a ray\n", 1e9 * (median(camera) + median(shadow)) / (pixels + double(shadows.rays)));
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
}
