package org.phrenic.anatomy.virtual;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;

/** The two bodies that come with the program, each grown once for all tests. */
public final class VirtualBodies {
    private static final Map<String, Thorax> GROWN = new ConcurrentHashMap<>();

    private VirtualBodies() {}

    public static Thorax grow(String preset, Resolution resolution) {
        return GROWN.computeIfAbsent(
                preset + resolution, key -> VirtualThorax.generate(VirtualThoraxParameters.preset(preset), resolution));
    }

    static SurfaceChecks surface(Thorax thorax, String name) {
        return new SurfaceChecks(thorax.find(name).orElseThrow().mesh());
    }

    static int vertices(Thorax thorax, StructureKind... kinds) {
        return thorax.structures().stream()
                .filter(s -> List.of(kinds).contains(s.kind()))
                .mapToInt(s -> s.mesh().vertexCount())
                .sum();
    }
}
