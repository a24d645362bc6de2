package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Vessels, airways, lesions and unknown structures within the liver or a lung. A voxel has one label, so that such
 * structures are missing from their organ, whose surface would run along every vessel. Their voxels are given to the
 * organ; their own surfaces are made from a copy of the voxels as they were.
 *
 * <p>Structures are looked at whose contact with the liver or with the lungs is at least a share of their surface. A
 * voxel of theirs lies in an organ if in at least four of the six directions of the grid the first voxel beyond such
 * structures belongs to that organ.
 */
public final class EnclosedStructures {
    /**
     * Least share of the faces of a structure's surface that the liver has. The inferior vena cava and the portal vein
     * with its trunk have 0.16 to 0.55 in scans, branches and lesions 0.98 and more.
     */
    private static final double LEAST_ON_LIVER = 0.5;
    /** Least share that the lungs have: a trachea with its bronchi has 0.2 and more, the pulmonary veins have 0.08. */
    private static final double LEAST_ON_LUNGS = 0.2;
    /** Least share that an organ with a lesion has, which may bulge out of it. */
    private static final double LEAST_OF_LESION = 0.1;
    /** Least number of directions, of six, in which a voxel within an organ meets it. */
    private static final int LEAST_DIRECTIONS = 4;

    private final Segmentation s;
    /** Kind of each segment's structure; null for background. */
    private final StructureKind[] kinds = new StructureKind[LabelGrid.MAX_BYTE_LABEL + 1];
    /** Whether each segment is a structure within organs. */
    private final boolean[] enclosed = new boolean[kinds.length];
    /** The voxels before organs were filled. */
    private byte[] own = new byte[0];

    private EnclosedStructures(Segmentation s) {
        this.s = s;
        for (int segment = 1; segment <= s.names().size(); segment++) {
            kinds[segment] = StructureName.parse(s.names().get(segment - 1))
                    .map(StructureName::kind)
                    .orElse(null);
        }
    }

    /** Finds the structures within organs. */
    public static EnclosedStructures find(Segmentation s) {
        EnclosedStructures found = new EnclosedStructures(s);
        long[] faces = new long[found.kinds.length];
        long[] onLiver = new long[found.kinds.length];
        long[] onLungs = new long[found.kinds.length];
        int[] steps = s.steps();
        for (int v = 0; v < s.voxels.length; v++) {
            int segment = s.segmentAt(v);
            for (int step = 0; step < steps.length && found.maybeEnclosed(segment); step++) {
                int next = s.isAtBorder(v, step) ? 0 : s.segmentAt(v + steps[step]);
                faces[segment] += found.maybeEnclosed(next) ? 0 : 1;
                onLiver[segment] += found.kinds[next] == StructureKind.LIVER ? 1 : 0;
                onLungs[segment] += found.kinds[next] == StructureKind.LUNG ? 1 : 0;
            }
        }
        for (int segment = 1; segment < faces.length; segment++) {
            boolean lesion = found.kinds[segment] == StructureKind.LESION;
            boolean inLiver = onLiver[segment] >= (lesion ? LEAST_OF_LESION : LEAST_ON_LIVER) * faces[segment];
            boolean inLungs = onLungs[segment] >= (lesion ? LEAST_OF_LESION : LEAST_ON_LUNGS) * faces[segment];
            found.enclosed[segment] = faces[segment] > 0 && (inLiver || inLungs);
        }
        return found;
    }

    private boolean maybeEnclosed(int segment) {
        StructureKind kind = kinds[segment];
        return kind == StructureKind.VESSEL || kind == StructureKind.LESION || kind == StructureKind.OTHER;
    }

    private boolean isOrgan(int segment) {
        return kinds[segment] == StructureKind.LIVER || kinds[segment] == StructureKind.LUNG;
    }

    /** Whether a structure lies within organs. */
    public boolean contains(String structure) {
        return enclosed[s.find(structure)];
    }

    /** The voxels before organs were filled; empty if nothing lies in them. */
    public Optional<LabelGrid> ownVoxels() {
        return own.length == 0
                ? Optional.empty()
                : Optional.of(
                        LabelGrid.of(s.columns, s.rows, s.slices, own, s.grid().toMm()));
    }

    /**
     * Gives the voxels of enclosed structures to the organs that they lie in.
     *
     * @return a note on what was given, if anything was
     */
    public Optional<String> fillOrgans() {
        if (s.names().stream().noneMatch(this::contains)) {
            return Optional.empty();
        }
        byte[] filled = s.voxels.clone();
        Map<String, Integer> given = new TreeMap<>();
        for (int v = 0; v < filled.length; v++) {
            int segment = s.segmentAt(v);
            int organ = enclosed[segment] ? organAround(v) : 0;
            if (organ > 0) {
                filled[v] = (byte) organ;
                given.merge(s.names().get(segment - 1) + " in " + s.names().get(organ - 1), 1, Integer::sum);
            }
        }
        if (given.isEmpty()) {
            return Optional.empty();
        }
        own = s.voxels;
        s.voxels = filled;
        double voxelMl = s.grid().volumeMl(1);
        List<String> parts = new ArrayList<>();
        given.forEach((what, count) -> parts.add(String.format(Locale.ROOT, "%s (%.1f ml)", what, count * voxelMl)));
        return Optional.of("surfaces of organs enclose what lies in them: " + String.join(", ", parts));
    }

    /** The organ that a voxel lies in; 0 for none. */
    private int organAround(int voxel) {
        int[] steps = s.steps();
        int[] met = new int[steps.length];
        for (int step = 0; step < steps.length; step++) {
            int v = voxel;
            while (enclosed[s.segmentAt(v)] && !s.isAtBorder(v, step)) {
                v += steps[step];
            }
            met[step] = isOrgan(s.segmentAt(v)) ? s.segmentAt(v) : 0;
        }
        Arrays.sort(met);
        for (int first = 0; first + LEAST_DIRECTIONS <= met.length; first++) {
            if (met[first] == met[first + LEAST_DIRECTIONS - 1] && met[first] > 0) {
                return met[first];
            }
        }
        return 0;
    }
}
