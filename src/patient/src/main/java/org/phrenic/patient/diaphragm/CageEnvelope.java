package org.phrenic.patient.diaphragm;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.shape.ImplicitSurface;
import org.phrenic.anatomy.virtual.shape.VerticalAxis;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.TriangleTree;

/**
 * The inner envelope of the rib cage: a smooth radius R(azimuth, z) about a vertical axis in front of the spine, along
 * the inner sides of ribs, cartilages, sternum and vertebrae and across the spaces between them.
 *
 * <p>Horizontal rays from the axis give the radius where they meet bone. The envelope is the asymmetric least-squares
 * thin plate through these radii (an expectile): a sample inside the envelope has weight 1, one outside it
 * {@value #OUTER_WEIGHT}, since rays that pass the rounded edge of a rib meet it farther out. As an implicit function
 * it is negative inside.
 */
public final class CageEnvelope implements ImplicitSurface, VerticalAxis {
    static final int SECTORS = 192;
    private static final double LAYER_MM = 3;
    private static final double OUTER_WEIGHT = 0.3;
    private static final ThinPlateGrid.Stiffness STIFFNESS = new ThinPlateGrid.Stiffness(5, 3);
    /** Thickness of ligament, vessels and fat in front of the vertebral bodies, mm. */
    private static final double SPINE_COVER_MM = 3;

    /** Distance inside the envelope at which a sample has half its weight, mm. */
    private static final double STRAY_MM = 20;

    private static final int ROUNDS = 6;
    /** Greatest distance by which organs push the wall out between bones, mm. */
    private static final double ORGAN_MM = 12;
    /** Weight of a radius to which an organ pushes the wall out: in corners the plate would cut the organ. */
    private static final double ORGAN_WEIGHT = 100;
    /** Position of the axis between the spine's front (0) and the sternum (1). */
    private static final double FORWARD = 0.5;
    /** Heights below vertebra L2 and above T8 to which the envelope reaches, mm. */
    private static final double BELOW_MM = 60;

    private static final double ABOVE_MM = 100;
    /** Margin below and above the bones, mm. */
    private static final double MARGIN_MM = 30;

    private static final double GREATEST_MM = 400;
    private static final double LOWEST_MM = 30;
    private static final int FIRST_LEVEL = 8;
    private static final int LAST_LEVEL = StructureName.FIRST_LUMBAR + 1;

    private final double axisX;
    private final double axisY;
    private final double bottom;
    private final int layers;
    private final double[] radius;

    /** @throws IllegalArgumentException if the body lacks ribs, vertebrae T8 to L2 or anything in front of them */
    public CageEnvelope(Thorax body) {
        this(body, null);
    }

    private CageEnvelope(Thorax body, CageEnvelope like) {
        List<Structure> spine = body.structuresOf(StructureKind.VERTEBRA).stream()
                .filter(s -> s.level() >= FIRST_LEVEL && s.level() <= LAST_LEVEL)
                .toList();
        List<TriangleMesh> bones = meshes(body, s -> isCage(s.kind()));
        int ofCage = bones.stream().mapToInt(TriangleMesh::triangleCount).sum();
        bones.addAll(meshes(body, s -> isSpine(s.kind())));
        if (spine.isEmpty() || body.structuresOf(StructureKind.RIB).isEmpty()) {
            throw new IllegalArgumentException("the body has no ribs or no lower thoracic vertebrae");
        }
        double[] box =
                MeshMerge.merge(spine.stream().map(Structure::mesh).toList()).bounds();
        TriangleMesh cage = MeshMerge.merge(bones);
        double[] all = cage.bounds();
        axisX = like == null ? 0.5 * (box[0] + box[3]) : like.axisX;
        axisY = like == null ? box[1] + FORWARD * (frontY(body, all) - box[1]) : like.axisY;
        bottom = Math.max(all[2], box[2] - BELOW_MM) - MARGIN_MM;
        int count = (int) Math.ceil((Math.min(all[5], box[5] + ABOVE_MM) + MARGIN_MM - bottom) / LAYER_MM) + 1;
        layers = (count + 15) / 16 * 16;
        double[] sample = samples(cage, ofCage);
        double[] ofBones = fit(sample, new double[sample.length], new double[0]);
        double[] ofOrgans = organRadii(body, sample, ofBones);
        radius = Arrays.stream(ofOrgans).anyMatch(r -> r > 0) ? fit(sample, ofOrgans, ofBones) : ofBones;
    }

    /** The envelope of another pose of the body about the axis of this one. */
    CageEnvelope about(Thorax other) {
        return new CageEnvelope(other, this);
    }

    private static List<TriangleMesh> meshes(Thorax body, Predicate<Structure> chosen) {
        List<TriangleMesh> meshes = new ArrayList<>();
        body.structures().stream().filter(chosen).map(Structure::mesh).forEach(meshes::add);
        return meshes;
    }

    private static boolean isCage(StructureKind kind) {
        return kind == StructureKind.RIB || kind == StructureKind.COSTAL_CARTILAGE || kind == StructureKind.STERNUM;
    }

    private static boolean isSpine(StructureKind kind) {
        return kind == StructureKind.VERTEBRA || kind == StructureKind.DISC;
    }

    /** The mean depth of the lowest {@value #LOWEST_MM} mm of the sternum; without a sternum, the front of the cage. */
    private static double frontY(Thorax body, double[] cage) {
        List<TriangleMesh> sternum = body.structuresOf(StructureKind.STERNUM).stream()
                .map(Structure::mesh)
                .toList();
        if (sternum.isEmpty()) {
            return cage[1];
        }
        TriangleMesh mesh = MeshMerge.merge(sternum);
        double low = mesh.bounds()[2] + LOWEST_MM;
        return IntStream.range(0, mesh.vertexCount())
                .filter(v -> mesh.z(v) < low)
                .mapToDouble(mesh::y)
                .average()
                .orElse(cage[1]);
    }

    private double[] samples(TriangleMesh cage, int firstOfSpine) {
        TriangleTree tree = new TriangleTree(cage);
        TriangleTree.Hit hit = new TriangleTree.Hit();
        double[] sample = new double[SECTORS * layers];
        for (int k = 0; k < sample.length; k++) {
            double azimuth = azimuth(k % SECTORS);
            int layer = k / SECTORS;
            double z = bottom + layer * LAYER_MM;
            boolean found =
                    tree.nearestAlongRay(axisX, axisY, z, StrictMath.sin(azimuth), StrictMath.cos(azimuth), 0, hit);
            double cover = hit.triangle >= firstOfSpine ? SPINE_COVER_MM : 0;
            sample[k] = found && hit.rayParameter < GREATEST_MM ? Math.max(1, hit.rayParameter - cover) : 0;
        }
        return sample;
    }

    /**
     * Radii of the outer side of lungs and abdominal organs, which lie inside the wall: at most to the inner side of
     * bone, between bones at most {@value #ORGAN_MM} mm outside their envelope, and 0 where there is no organ.
     */
    private double[] organRadii(Thorax body, double[] sample, double[] ofBones) {
        List<TriangleMesh> organs = meshes(body, s -> s.kind() == StructureKind.LUNG);
        ContactingOrgans.abdominal(body).stream().map(Structure::mesh).forEach(organs::add);
        double[] out = new double[sample.length];
        if (organs.isEmpty()) {
            return out;
        }
        TriangleTree tree = new TriangleTree(MeshMerge.merge(organs));
        TriangleTree.Hit hit = new TriangleTree.Hit();
        for (int k = 0; k < out.length; k++) {
            double azimuth = azimuth(k % SECTORS);
            int layer = k / SECTORS;
            double[] far = point(azimuth, GREATEST_MM, bottom + layer * LAYER_MM);
            boolean found = tree.nearestAlongRay(
                    far[0], far[1], far[2], -StrictMath.sin(azimuth), -StrictMath.cos(azimuth), 0, hit);
            double r = found ? GREATEST_MM - hit.rayParameter : 0;
            out[k] = Math.max(0, Math.min(r, sample[k] > 0 ? sample[k] : ofBones[k] + ORGAN_MM));
        }
        return out;
    }

    /**
     * Iteratively reweighted least squares.
     *
     * @param least radii to which organs push the envelope out
     * @param start envelope from which the first weights are; empty for equal ones
     */
    private double[] fit(double[] sample, double[] least, double[] start) {
        double[] found = Arrays.stream(sample).filter(r -> r > 0).toArray();
        double mean = Arrays.stream(found).average().orElse(1);
        ThinPlateGrid.Grid grid = new ThinPlateGrid.Grid(SECTORS, layers, mean * 2 * Math.PI / SECTORS, LAYER_MM, true);
        double[] weight = new double[sample.length];
        Arrays.setAll(weight, k -> sample[k] > 0 ? 1 : 0);
        double[] fitted = start;
        double[] data = sample.clone();
        for (int round = 0; round < ROUNDS; round++) {
            for (int k = 0; k < fitted.length; k++) {
                boolean pushed = fitted[k] < least[k];
                data[k] = pushed ? least[k] : sample[k];
                weight[k] = pushed ? ORGAN_WEIGHT : sample[k] == 0 ? 0 : weight(sample[k] - fitted[k]);
            }
            fitted = ThinPlateGrid.solve(grid, new ThinPlateGrid.Data(data, weight), STIFFNESS, fitted);
        }
        return fitted;
    }

    /** Weight of a sample by its distance outside the envelope; specks of bone far inside have little. */
    private static double weight(double outside) {
        double far = outside / STRAY_MM;
        return outside > 0 ? OUTER_WEIGHT : 1 / (1 + far * far);
    }

    static double azimuth(int sector) {
        return 2 * Math.PI * sector / SECTORS;
    }

    @Override
    public double x(double z) {
        return axisX;
    }

    @Override
    public double y(double z) {
        return axisY;
    }

    /** Azimuth of a point about the axis, rad. */
    public double azimuth(double px, double py) {
        return StrictMath.atan2(px - axisX, py - axisY);
    }

    /** Radius of the envelope at an azimuth (rad) and a height (mm), mm. */
    public double radius(double azimuth, double z) {
        double s = azimuth / (2 * Math.PI) * SECTORS;
        double sector = s - SECTORS * Math.floor(s / SECTORS);
        double layer = Math.max(0, Math.min(layers - 1.001, (z - bottom) / LAYER_MM));
        int i = Math.min(SECTORS - 1, (int) sector);
        int j = (int) layer;
        int next = i < SECTORS - 1 ? i + 1 : 0;
        double past = sector - i;
        double above = layer - j;
        int row = SECTORS * j;
        return (1 - above) * ((1 - past) * radius[row + i] + past * radius[row + next])
                + above * ((1 - past) * radius[row + SECTORS + i] + past * radius[row + SECTORS + next]);
    }

    /** First-order distance to the envelope, mm; negative inside. */
    @Override
    public double at(double px, double py, double pz) {
        double distance = Math.max(1e-6, StrictMath.hypot(px - axisX, py - axisY));
        double azimuth = azimuth(px, py);
        double r = radius(azimuth, pz);
        double turn = 2 * Math.PI / SECTORS;
        double around = (radius(azimuth + turn, pz) - radius(azimuth - turn, pz)) / (2 * turn * Math.max(r, 1));
        double up = (radius(azimuth, pz + LAYER_MM) - radius(azimuth, pz - LAYER_MM)) / (2 * LAYER_MM);
        return (distance - r) / Math.sqrt(1 + around * around + up * up);
    }
}
