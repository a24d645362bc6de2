package org.phrenic.patient.registration;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.Vectors;
import org.phrenic.mesh.query.TriangleTree;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.PatientBody;

/**
 * Fits the bones of a template to those of a scan: vertebrae one by one, ribs along their courses, sternum and
 * cartilages by nearest points, and where those are missing the costal surfaces of the lungs. A smooth field
 * ({@link SmoothField}) carries what is known to levels and sides of which the scan shows nothing.
 */
final class BoneFit {
    private static final SmoothField.Scale[] SCALES = {
        new SmoothField.Scale(500, 15), new SmoothField.Scale(220, 10), new SmoothField.Scale(90, 5)
    };
    /** Correlation of both sides; people are not quite symmetric. */
    private static final double MIRROR = 0.9;

    private static final int SLIDING_ROUNDS = 4;
    private static final int COURSE_ROUNDS = 2;
    private static final int VERTEBRA_POINTS = 12;
    private static final double VERTEBRA_SIGMA_MM = 1;
    private static final int STERNUM_POINTS = 50;
    private static final double STERNUM_SIGMA_MM = 2;
    /** The part of a sternum below its body. */
    private static final String XIPHOID = "sternum_xiphoid";
    /** Height of the lower end of a sternum, mm. */
    private static final double STERNUM_END_MM = 10;
    /** Vertices nearer to the end of a scan than this lie at the cut, mm. */
    private static final double AT_CUT_MM = 3;
    /** Least share of a sternum cut at its front or a side that tells where the rest lies, as of a vertebra. */
    private static final double LEAST_STERNUM = 0.4;

    private static final int CARTILAGE_POINTS = 6;
    private static final double CARTILAGE_SIGMA_MM = 4;
    private static final int LUNG_POINTS = 80;
    private static final double LUNG_SIGMA_MM = 6;
    private static final double LIVER_SIGMA_MM = 15;
    /** Whole vertebrae and ribs, whole or in part, from which on the heights of organs say nothing more of bones. */
    static final int LEAST_VERTEBRAE = 3;

    /** Share of a vertebra that the scan shows from which on it is fitted as a whole one. */
    private static final double WHOLE_SHARE = 0.7;

    private static final int LEAST_RIBS = 6;
    /** Of a spine under one label, whose vertebrae may lie at other heights. */
    private static final double SPINE_SIGMA_MM = 4;

    /** The ribs of a scan end short of the spine if half of them have more than this to their joints, mm. */
    private static final double USUAL_GAP_MM = 2;

    private static final double SHORT_AMONG_SHORT_MM = 1;
    private static final double SHORT_AMONG_WHOLE_MM = 6;

    private final TemplateMap start;
    private final double plane;
    private final List<SharedStructure> vertebrae = new ArrayList<>();
    /** Similarity from each vertebra of the template to the scan's, by level. */
    private final Map<Integer, PointTransform> onVertebrae = new TreeMap<>();

    private final List<Structure> template;
    private final List<RibFit> ribs = new ArrayList<>();
    private final List<SurfacePair> surfaces = new ArrayList<>();
    /** Lower ends of sterna that the scan cuts off above. */
    private final PointPairs sternumEnds = new PointPairs();
    /** The upper end of a scan that shows costal cartilages and no sternum. */
    private final Optional<CutPlane> belowSternum;

    /**
     * @param start first alignment of the template
     * @param plane x of its plane of symmetry, mm
     * @param organs pairs of surfaces of lungs and liver, and of a spine under one label
     */
    BoneFit(
            TemplateMap start,
            double plane,
            List<Structure> template,
            List<SharedStructure> shared,
            List<SurfacePair> organs) {
        this.start = start;
        this.template = template;
        this.plane = plane;
        for (SharedStructure s : shared) {
            if (isShown(s, start)) {
                vertebrae.add(s);
            } else if (s.kind() == StructureKind.RIB) {
                ribs.add(new RibFit(s));
            } else if (s.kind() == StructureKind.VERTEBRA) {
                surfaces.add(s.pair(true));
            } else if (s.kind() == StructureKind.COSTAL_CARTILAGE) {
                surfaces.add(s.pair(true));
            } else if (s.kind() == StructureKind.STERNUM) {
                addSternum(s);
            }
        }
        boolean bonesTell = bonesTell(shared, start, organs);
        organs.stream().filter(organ -> !bonesTell || tellsBesideBones(organ)).forEach(surfaces::add);
        belowSternum = SharedStructure.belowSternum(shared);
    }

    /** Adds a sternum, unless the front or a side of the scan leaves the smaller part of it. */
    private void addSternum(SharedStructure s) {
        if (s.organ().isCutAlongBody() || s.shownShare(start.apply(s.template())) >= LEAST_STERNUM) {
            surfaces.add(s.pair(true));
        }
        if (s.cutAt().equals("S") || showsLowerEnd(s)) {
            sternumEnds.add(lowerEnd(s.template()), lowerEnd(s.scan()), STERNUM_SIGMA_MM);
        }
    }

    /** Whether a scan cuts a sternum off above and has no other end at its lower end. */
    static boolean showsLowerEnd(SharedStructure s) {
        boolean[] atCut = s.organ().verticesAtCut(AT_CUT_MM);
        double bound = s.scan().bounds()[2] + STERNUM_END_MM;
        return s.cutAt().contains("S")
                && !s.cutAt().contains("I")
                && IntStream.range(0, atCut.length)
                        .noneMatch(v -> atCut[v] && s.scan().z(v) < bound);
    }

    /**
     * Whether a scan ends within the lungs and shows enough bones, so that neither the liver nor these lungs say more
     * of where bones lie.
     */
    static boolean bonesTell(List<SharedStructure> bones, TemplateMap placed, List<SurfacePair> organs) {
        return organs.stream().anyMatch(organ -> organ.kind() == StructureKind.LUNG && !organ.isComplete())
                && bones.stream().filter(s -> isShown(s, placed)).count() >= LEAST_VERTEBRAE
                && bones.stream().filter(s -> s.kind() == StructureKind.RIB).count() >= LEAST_RIBS;
    }

    /** Whether a scan shows a vertebra whole or but for a small part. */
    static boolean isShown(SharedStructure s, TemplateMap placed) {
        return s.kind() == StructureKind.VERTEBRA && s.shownShare(placed.apply(s.template())) >= WHOLE_SHARE;
    }

    /**
     * Whether an organ tells where bones lie beyond the end of a scan that cuts lungs off and shows enough bones. Liver
     * and lower ends of lungs stand at other heights against the spine in other people, and lower at inspiration.
     */
    static boolean tellsBesideBones(SurfacePair organ) {
        return organ.kind() != StructureKind.LIVER && (organ.kind() != StructureKind.LUNG || organ.isComplete());
    }

    /**
     * Points of a sternum that the scan does not show, moved as a whole so that its body ends at the upper end of the
     * scan, if that would end below it; a xiphoid process of cartilage has no label.
     */
    private PointPairs unseenSternum(TemplateMap map) {
        PointPairs pairs = new PointPairs();
        Optional<TriangleMesh> bone = PatientBody.merged(template.stream()
                .filter(s -> s.kind() == StructureKind.STERNUM && !s.name().equals(XIPHOID)));
        if (belowSternum.isPresent() && bone.isPresent()) {
            double[] end = lowerEnd(bone.get());
            map.apply(end);
            double depth = belowSternum.get().depth(end);
            int n = bone.get().vertexCount();
            for (int i = 0; i < STERNUM_POINTS && depth > 0; i++) {
                int v = (int) ((long) i * n / STERNUM_POINTS);
                double[] point = {bone.get().x(v), bone.get().y(v), bone.get().z(v)};
                double[] placed = point.clone();
                map.apply(placed);
                pairs.add(point, belowSternum.get().moved(placed, depth), STERNUM_SIGMA_MM);
            }
        }
        return pairs;
    }

    private static double[] lowerEnd(TriangleMesh sternum) {
        double bound = sternum.bounds()[2] + STERNUM_END_MM;
        double[] end = new double[3];
        int count = 0;
        for (int v = 0; v < sternum.vertexCount(); v++) {
            if (sternum.z(v) < bound) {
                count++;
                end[0] += sternum.x(v);
                end[1] += sternum.y(v);
                end[2] += sternum.z(v);
            }
        }
        return new double[] {end[0] / count, end[1] / count, end[2] / count};
    }

    /** Ribs that scan and template share, after the fit. */
    List<RibFit> ribs() {
        return ribs;
    }

    TemplateMap fit() {
        PointPairs known = spine(start);
        int ofSpine = known.count();
        TemplateMap map = fit(known);
        known.addAll(unseenSternum(map));
        return known.count() == ofSpine ? map : fit(known);
    }

    /** @param known points whose places are known, which keep them in all rounds */
    private TemplateMap fit(PointPairs known) {
        ribs.forEach(RibFit::forgetNeck);
        TemplateMap map = known.count() == 0 ? start : start.through(known, SCALES, MIRROR, plane);
        for (int round = 0; round < SLIDING_ROUNDS + COURSE_ROUNDS; round++) {
            PointPairs pairs = new PointPairs();
            pairs.addAll(known);
            pairs.addAll(sternumEnds);
            Vertebrae placedVertebrae = new Vertebrae(map);
            for (RibFit rib : ribs) {
                rib.place(map);
                if (round >= SLIDING_ROUNDS) {
                    findHead(rib, placedVertebrae);
                }
            }
            judgeNecks();
            ribs.forEach(rib -> pairs.addAll(rib.pairs()));
            TemplateMap placed = map;
            surfaces.forEach(pair -> {
                pair.place(placed);
                pairs.addAll(pair.nearest(points(pair), sigma(pair)));
            });
            map = start.through(pairs, SCALES, MIRROR, plane);
        }
        for (RibFit rib : ribs) {
            rib.place(map);
        }
        return map;
    }

    /** Tells ribs that end short of the spine from whole ones: a segmentation ends most of its ribs alike. */
    private void judgeNecks() {
        double[] gaps = ribs.stream()
                .map(RibFit::gapMm)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .sorted()
                .toArray();
        if (gaps.length > 0) {
            double limit = gaps[gaps.length / 2] > USUAL_GAP_MM ? SHORT_AMONG_SHORT_MM : SHORT_AMONG_WHOLE_MM;
            ribs.forEach(rib -> rib.judge(limit));
        }
    }

    private static void findHead(RibFit rib, Vertebrae all) {
        int level = rib.shared().level();
        Optional<CostovertebralJoint.Vertebra> own = all.measured(level);
        if (own.isPresent()) {
            rib.findHead(new CostovertebralJoint(level, rib.side(), own.get(), all.measured(level - 1)));
        }
    }

    private Optional<TriangleMesh> ofTemplate(int level) {
        return PatientBody.merged(
                template.stream().filter(s -> s.kind() == StructureKind.VERTEBRA && s.level() == level));
    }

    private static int points(SurfacePair pair) {
        return switch (pair.kind()) {
            case STERNUM -> STERNUM_POINTS;
            case COSTAL_CARTILAGE -> CARTILAGE_POINTS;
            case VERTEBRA -> VERTEBRA_POINTS;
            default -> LUNG_POINTS;
        };
    }

    private static double sigma(SurfacePair pair) {
        return switch (pair.kind()) {
            case STERNUM -> STERNUM_SIGMA_MM;
            case COSTAL_CARTILAGE -> CARTILAGE_SIGMA_MM;
            case LUNG -> LUNG_SIGMA_MM;
            case VERTEBRA, BONE -> SPINE_SIGMA_MM;
            default -> LIVER_SIGMA_MM;
        };
    }

    /** Points of the vertebrae, each placed by a similarity. */
    private PointPairs spine(TemplateMap map) {
        PointPairs pairs = new PointPairs();
        for (SharedStructure s : vertebrae) {
            TriangleMesh placed = map.apply(s.template());
            double[] fitted = VertebraFit.fit(placed, s.scan());
            double[] rest = s.template().positions();
            onVertebrae.put(s.level(), AffineTransform3D.similarity(rest, fitted));
            int n = s.template().vertexCount();
            for (int i = 0; i < VERTEBRA_POINTS; i++) {
                int v = (int) ((long) i * n / VERTEBRA_POINTS);
                pairs.add(
                        new double[] {rest[3 * v], rest[3 * v + 1], rest[3 * v + 2]},
                        new double[] {fitted[3 * v], fitted[3 * v + 1], fitted[3 * v + 2]},
                        VERTEBRA_SIGMA_MM);
            }
        }
        return pairs;
    }

    /** Vertebrae of a round of the fit, each measured when the first rib asks for it. */
    private final class Vertebrae {
        private final TemplateMap map;
        private final Map<Integer, Optional<TriangleMesh>> surfaces = new HashMap<>();
        private final Map<Integer, Optional<CostovertebralJoint.Vertebra>> measured = new HashMap<>();

        Vertebrae(TemplateMap map) {
            this.map = map;
        }

        /** A vertebra with the measures of its body; its left is that of the template. */
        Optional<CostovertebralJoint.Vertebra> measured(int level) {
            return measured.computeIfAbsent(level, this::measure);
        }

        private Optional<CostovertebralJoint.Vertebra> measure(int level) {
            Optional<double[]> middle = ofTemplate(level).map(RoughAlignment::centroid);
            if (middle.isEmpty()) {
                return Optional.empty();
            }
            double[] c = middle.get();
            double[] across = {c[0] - 1, c[1], c[2], c[0] + 1, c[1], c[2]};
            (onVertebrae.containsKey(level) ? onVertebrae.get(level) : map).apply(across);
            double[] left = {across[3] - across[0], across[4] - across[1], across[5] - across[2]};
            return surface(level).map(mesh -> {
                double[] centre = RoughAlignment.centroid(mesh);
                double[] above =
                        surface(level - 1).map(RoughAlignment::centroid).orElse(centre);
                double[] below =
                        surface(level + 1).map(RoughAlignment::centroid).orElse(centre);
                TriangleTree bone = new TriangleTree(mesh);
                double[] up = Vectors.subtract(above, below);
                return new CostovertebralJoint.Vertebra(bone, VertebralBody.of(bone, left, up));
            });
        }

        /** A vertebra of the scan, or where it has none that of the placed template. */
        private Optional<TriangleMesh> surface(int level) {
            return surfaces.computeIfAbsent(level, l -> vertebrae.stream()
                    .filter(s -> s.level() == l)
                    .map(SharedStructure::scan)
                    .findFirst()
                    .or(() -> ofTemplate(l).map(map::apply)));
        }
    }
}
