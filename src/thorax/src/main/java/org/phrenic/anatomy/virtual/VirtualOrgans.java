package org.phrenic.anatomy.virtual;

import java.util.List;
import java.util.function.Supplier;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.SoftValues;
import org.phrenic.file.UserCache;

/** The organs and vessels of a virtual body, generated or read from a cache when they are first asked for. */
final class VirtualOrgans implements Supplier<List<Structure>> {
    /** Organs of presets without a cache by name, kept while memory allows. */
    private static final SoftValues<VirtualOrgans> PRESETS = new SoftValues<>();

    private final Supplier<List<Structure>> source;
    private List<Structure> kept;

    private VirtualOrgans(Supplier<List<Structure>> source) {
        this.source = source;
    }

    /** Organs from measures. */
    static VirtualOrgans of(VirtualThoraxParameters parameters) {
        return new VirtualOrgans(() -> new OrganBuilder(parameters).build());
    }

    /** Organs of a preset, which a cache keeps. They do not depend on the number of vertices of the body. */
    static VirtualOrgans ofPreset(String preset, UserCache cache) {
        return cache.isOff() ? PRESETS.get(preset, () -> in(cache, preset)) : in(cache, preset);
    }

    private static VirtualOrgans in(UserCache cache, String preset) {
        return new VirtualOrgans(() -> CachedBody.in(cache, "organs " + preset, () -> {
                    VirtualThoraxParameters parameters = VirtualThoraxParameters.preset(preset);
                    return new Thorax(preset, new OrganBuilder(parameters).build(), List.of());
                })
                .structures());
    }

    @Override
    public synchronized List<Structure> get() {
        if (kept == null) {
            kept = source.get();
        }
        return kept;
    }
}
