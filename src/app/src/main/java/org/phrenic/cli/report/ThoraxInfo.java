package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.ThoraxFolder;

/** What a thorax folder holds, and what a whole thorax has besides. */
public final class ThoraxInfo {
    private static final int RIBS = 12;

    private ThoraxInfo() {}

    public static Map<String, Object> of(Path folder) {
        Thorax thorax = ThoraxFolder.load(folder);
        Map<String, Object> counts = new LinkedHashMap<>();
        for (StructureKind kind : StructureKind.values()) {
            if (!thorax.structuresOf(kind).isEmpty()) {
                counts.put(
                        kind.name().toLowerCase(Locale.ROOT),
                        thorax.structuresOf(kind).size());
            }
        }
        Map<String, Object> info = new LinkedHashMap<>();
        info.put("file", folder.toString());
        info.put("kind", "thorax");
        info.put("name", thorax.name());
        // The loader's first note says which axes and unit were stated or read off the body.
        info.put("frame", thorax.notes().get(0));
        info.put("structures", counts);
        info.put("triangles", sum(thorax));
        info.put("missing", missing(thorax));
        info.put("notes", thorax.notes().subList(1, thorax.notes().size()));
        return info;
    }

    private static int sum(Thorax thorax) {
        return thorax.structures().stream()
                .map(Structure::mesh)
                .mapToInt(mesh -> mesh.triangleCount())
                .sum();
    }

    private static List<String> missing(Thorax thorax) {
        List<String> missing = new ArrayList<>();
        for (Side side : List.of(Side.RIGHT, Side.LEFT)) {
            for (int level = 1; level <= RIBS; level++) {
                if (thorax.find(StructureKind.RIB, level, side).isEmpty()) {
                    missing.add(String.format(Locale.ROOT, "rib_%02d_%s", level, side == Side.RIGHT ? "R" : "L"));
                }
            }
            if (thorax.structuresOf(StructureKind.LUNG).stream().noneMatch(lung -> lung.side() == side)) {
                missing.add(side == Side.RIGHT ? "lung_R" : "lung_L");
            }
        }
        for (StructureKind kind : List.of(
                StructureKind.STERNUM,
                StructureKind.COSTAL_CARTILAGE,
                StructureKind.VERTEBRA,
                StructureKind.LIVER,
                StructureKind.SKIN)) {
            if (thorax.structuresOf(kind).isEmpty()) {
                missing.add(kind.name().toLowerCase(Locale.ROOT));
            }
        }
        return missing;
    }
}
