/* vulkan.cpp - draws a capture (capture.c) by the loop of a host, examples/hosts/vulkan.cpp; for vulkan.sh.

      build/vulkan-replay CAPTURE [TEXTS] [ID=VALUE ..] [out=FILE]

   TEXTS: the folder of shaders and manifest, unless it is the capture's own. ID=VALUE: a specialisation constant.
   FILE: all results of all frames, as bytes, one after another.
   Prints the largest RMSE of all frames and results against the kit's. Status 1: the validation layer had a message, or
   a result shows no surface, so that nothing was compared. */
#define main host_main
#include "../examples/hosts/vulkan.cpp"
#undef main

static std::string data_of(const std::string &folder, const json &number)
{
    return file_of(folder + "/" + std::to_string(number.get<int>()) + ".bin");
}

struct replay {
    gpu &g;
    std::string folder;
    json capture;
    chain c;
    std::map<int, image> textures; /* the capture's textures, by its numbers */
    std::map<int, buffer> buffers; /* its data, as uniform blocks and surfels */
    std::ofstream out;
    double worst = 0;
    bool flat = false;

    image *texture(int number)
    {
        if (!textures.count(number)) {
            const json &t = capture["textures"].at((size_t)number);
            std::string data = data_of(folder, t["data"]);
            if (data.size()
                != t["bytes"].get<size_t>() * t["width"].get<size_t>() * t["height"].get<size_t>()
                       * std::max(t["layers"].get<size_t>(), size_t{ 1 }))
                throw std::runtime_error("texture " + std::to_string(number) + ": its data has another size");
            image i = g.image_of(t["vulkan"].get<vk::Format>(), t["width"], t["height"], t["layers"]);
            g.copy(i, data.data(), data.size(), true);
            textures.emplace(number, std::move(i));
        }
        return &textures.at(number);
    }

    vk::Buffer data(const json &number)
    {
        if (!buffers.count(number)) {
            const std::string bytes = data_of(folder, number);
            buffers.emplace(number, g.buffer_of(bytes.size(), bytes.data()));
        }
        return *buffers.at(number).buffer;
    }

    void set(step &s, const json &is, const json &surfels)
    {
        if (s.width != is["width"] || s.height != is["height"])
            throw std::runtime_error(s.is["pass"].get<std::string>() + ": draws into another size than the kit");
        s.frame = data(is["frame"]);
        s.instances = is["instances"];
        if (s.is["pass"] == "dss") s.surfels = data(surfels["data"]);
        for (size_t k = 0; k < s.yours.size(); ++k) s.yours[k] = is["yours"][k] < 0 ? nullptr : texture(is["yours"][k]);
    }

    /* Compares one channel, or the first three of four: the others hold depth and the like. Pixels must show a
       surface. */
    void compare(const json &result)
    {
        const json &t = capture["textures"].at(result["is"].get<size_t>());
        const std::string data = data_of(folder, t["data"]);
        const size_t n = t["bytes"].get<size_t>() / 4, shown = n == 4 ? 3 : 1, texels = data.size() / 4 / n;
        std::vector<float> is(texels * n), want(texels * n);
        memcpy(want.data(), data.data(), data.size());
        g.copy(c.textures.at(result["texture"]).front(), is.data(), data.size(), false);
        if (out.is_open()) out.write((const char *)is.data(), (std::streamsize)data.size());
        double squares = 0;
        float least = INFINITY, most = -INFINITY;
        for (size_t i = 0; i < texels * n; ++i) {
            if (i % n >= shown) continue;
            squares += pow((double)is[i] - (double)want[i], 2);
            least = fminf(least, want[i]);
            most = fmaxf(most, want[i]);
        }
        const double rmse = sqrt(squares / (double)(texels * shown));
        worst = rmse <= worst ? worst : rmse; /* keeps NaN */
        flat = flat || !(most - least > 0.1f);
    }

    void play()
    {
        for (const json &frame : capture["frames"]) {
            for (size_t i = 0; i < c.steps.size(); ++i) set(c.steps[i], frame["steps"].at(i), frame["surfels"]);
            for (int i = 0; i < frame["draws"]; ++i) draw(g, c);
            if (frame["results"].empty()) flat = true;
            for (const json &result : frame["results"]) compare(result);
        }
    }
};

static int tested(const std::string &folder, std::string texts, int constants, char **constant)
{
    std::string out;
    std::vector<int> values;
    std::vector<vk::SpecializationMapEntry> entries;
    for (int i = 0; i < constants; ++i) {
        if (!strncmp(constant[i], "out=", 4)) {
            out = constant[i] + 4;
            continue;
        }
        entries.push_back({ (uint32_t)atoi(constant[i]), (uint32_t)(values.size() * sizeof(int)), sizeof(int) });
        values.push_back(atoi(strchr(constant[i], '=') + 1));
    }
    const vk::SpecializationInfo special(entries, vk::ArrayProxyNoTemporaries<const int>(values));
    const json manifest = json::parse(file_of(texts + "/manifest.json"));
    gpu g(true, 0, 2, manifest["chains"].at(0)["chain"]["desc"].contains("compute"));
    json capture = json::parse(file_of(folder + "/capture.json"));
    const int width = capture["width"], height = capture["height"];
    replay r{ g, folder, std::move(capture), chain_of(g, texts, width, height, &special), {}, {}, {} };
    if (!out.empty()) r.out.open(out, std::ios::binary);
    r.play();
    printf("%.6f\n", r.worst);
    if (r.flat) std::cerr << "vulkan-replay: " << folder << ": a result shows nothing\n";
    return messages || r.flat;
}

int main(int argc, char **argv)
{
    if (argc < 2) {
        std::cerr << "usage: vulkan-replay CAPTURE [TEXTS] [ID=VALUE ..] [out=FILE]\n";
        return 2;
    }
    const int first = argc > 2 && !strchr(argv[2], '=') ? 3 : 2;
    for (int i = first; i < argc; ++i) {
        if (strchr(argv[i], '=')) continue;
        std::cerr << "vulkan-replay: " << argv[i] << ": must be ID=VALUE or out=FILE\n";
        return 2;
    }
    try {
        return tested(argv[1], argv[first - 1], argc - first, argv + first);
    } catch (const std::exception &e) {
        std::cerr << "vulkan-replay: " << e.what() << "\n";
        return 2;
    }
}
