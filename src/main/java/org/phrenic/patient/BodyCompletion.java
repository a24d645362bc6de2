package org.phrenic.patient;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.Meshes;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.geometry.TriangleMesh;

/**
 * Gives a body what its scan lacks: a template thorax is brought to the structures that both have, by a similarity, then an affine map, then ever finer smooth warps ({@link WarpField}), each found from the points
 * of the two surfaces that lie nearest to each other; and lends its other structures. A structure that the scan cuts off is lent too, brought to the part that can be seen.
 */
public final class BodyCompletion {
    private static final int STEPS = 40;
    private static final double[] RADII_MM = {160, 120, 90, 60, 40};
    private static final int WARPS_A_RADIUS = 5;
    /** Warps of a smaller radius bend bones out of shape: they follow soft organs alone. */
    private static final double BONE_RADIUS_MM = 120;

    private static final Set<StructureKind> BONES = EnumSet.of(
            StructureKind.RIB,
            StructureKind.COSTAL_CARTILAGE,
            StructureKind.STERNUM,
            StructureKind.VERTEBRA,
            StructureKind.DISC);

    private final List<Structure> template;
    private final Map<String, SharedSurface> shared = new LinkedHashMap<>();

    private BodyCompletion(FittedBody body, Thorax template) {
        this.template = new ArrayList<>(template.structures());
        for (Organ organ : body.organs()) {
            List<TriangleMesh> parts = this.template.stream()
                    .filter(s -> isSame(s, organ.structure()))
                    .map(Structure::mesh)
                    .toList();
            if (!parts.isEmpty()) {
                shared.put(organ.structure().name(), new SharedSurface(organ, Meshes.merge(parts)));
            }
        }
    }

    private static boolean isSame(Structure a, Structure b) {
        return a.kind() == b.kind() && a.level() == b.level() && a.side() == b.side();
    }

    /**
     * The body with the structures of a template that it lacks, or as it is, with a note, if the scan has no whole lung to bring a template to.
     *
     * @param template LPS, mm, at end-expiration
     */
    public static FittedBody complete(FittedBody body, Thorax template) {
        boolean lung = body.organs().stream()
                .anyMatch(o -> o.structure().kind() == StructureKind.LUNG
                        && o.scan().map(Organ.Scan::isWhole).orElse(false));
        if (!lung) {
            return noted(
                    body,
                    "not completed from " + template.name()
                            + ": the scan has no whole lung, and without one a virtual thorax cannot be brought to it");
        }
        BodyCompletion completion = new BodyCompletion(body, template);
        completion.fit();
        return completion.completed(body, template.name());
    }

    private static FittedBody noted(FittedBody body, String note) {
        List<String> notes = new ArrayList<>(body.notes());
        notes.add(note);
        return new FittedBody(body.name(), body.organs(), body.missing(), notes);
    }

    private void fit() {
        List<SharedSurface> whole =
                shared.values().stream().filter(SharedSurface::isWhole).toList();
        move(
                AffineMap.ofBoxes(
                        box(whole.stream().map(SharedSurface::template).toList()),
                        box(whole.stream().map(SharedSurface::scan).toList())),
                true);
        for (int step = 0; step < STEPS; step++) {
            double[][] pairs = pairs();
            move(
                    step < STEPS / 2 ? AffineMap.similarity(pairs[0], pairs[1]) : AffineMap.affine(pairs[0], pairs[1]),
                    true);
        }
        for (double radius : RADII_MM) {
            for (int step = 0; step < WARPS_A_RADIUS; step++) {
                double[][] pairs = pairs();
                double[] bounds = box(template.stream().map(Structure::mesh).toList());
                move(new WarpField(pairs[0], pairs[1], radius, bounds), radius >= BONE_RADIUS_MM);
            }
        }
    }

    private double[][] pairs() {
        List<double[]> from = new ArrayList<>();
        List<double[]> to = new ArrayList<>();
        shared.values().forEach(s -> s.addPairs(from, to));
        return new double[][] {flat(from), flat(to)};
    }

    private static double[] flat(List<double[]> points) {
        double[] all = new double[3 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            System.arraycopy(points.get(i), 0, all, 3 * i, 3);
        }
        return all;
    }

    private void move(PointMap map, boolean bones) {
        shared.values().stream().filter(s -> bones || !BONES.contains(s.kind())).forEach(s -> s.move(map));
        template.replaceAll(s -> {
            if (!bones && BONES.contains(s.kind())) {
                return s;
            }
            double[] p = s.mesh().positions().clone();
            map.apply(p);
            return s.withMesh(s.mesh().withPositions(p));
        });
    }

    private FittedBody completed(FittedBody body, String from) {
        List<Organ> organs = new ArrayList<>();
        List<String> lent = new ArrayList<>();
        for (Organ organ : body.organs()) {
            boolean kept = organ.scan().map(Organ.Scan::isWhole).orElse(true)
                    || !shared.containsKey(organ.structure().name());
            if (kept) {
                SharedSurface surface = shared.get(organ.structure().name());
                organs.add(surface == null ? organ : organ.withOffScan(surface.off()));
            }
        }
        for (Structure structure : template) {
            if (organs.stream().noneMatch(o -> isSame(o.structure(), structure) && o.source() == Organ.Source.SCAN)) {
                Optional<Organ> seen = body.organs().stream()
                        .filter(o -> isSame(o.structure(), structure))
                        .findFirst();
                Organ organ =
                        new Organ(structure, Organ.Source.VIRTUAL, seen.flatMap(Organ::scan), seen.map(o -> shared.get(
                                        o.structure().name())
                                .off()));
                organs.add(organ);
                lent.add(structure.name());
            }
        }
        organs.sort(Comparator.comparing(o -> o.structure().name()));
        List<String> notes = new ArrayList<>(body.notes());
        notes.add(String.format(
                Locale.ROOT,
                "%d structures come from %s, brought to the %d that it shares with the scan",
                lent.size(),
                from,
                shared.size()));
        return new FittedBody(body.name(), organs, ThoraxList.missing(organs), notes);
    }

    private static double[] box(List<TriangleMesh> meshes) {
        return Meshes.merge(meshes).bounds();
    }
}
