package org.phrenic.simulation.observe;

import java.util.Arrays;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.anatomy.cage.RibCagePose;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.anatomy.virtual.shape.SmoothBlends;
import org.phrenic.engine.force.FallOff;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;

/**
 * Motion of the skin, for display only: it affects neither forces nor observables.
 *
 * <p>Over the rib cage the skin follows the bones below it ({@link LinearBlendSkinning}), fully near bone and not at
 * all far from it: {@code x = X + f(d) (x_bones(X) - X)}. {@code d} is the distance from bone; {@code f} is 1 up to
 * {@value #WITH_BONE_MM} mm and falls to 0 over the next {@value #FADE_MM} mm.
 *
 * <p>The abdominal wall moves outward by the volume that the diaphragm displaces, because the abdominal contents are
 * incompressible (De Troyer and Boriek 2011, doi 10.1002/cphy.c100009). {@code V} is the volume swept by the abdominal
 * face of the diaphragm minus the part due to the motion of the apposed rib cage. Each point of the anterior and
 * lateral wall between costal margin and pubis moves along its normal by {@code V w / Σ w A}, where {@code w} is a
 * smooth weight and {@code A} the area of a vertex. The sum is over all skins of the body, so that one in several
 * pieces moves as a whole one. Skin that ends above the pubis takes the corresponding share of the volume. Front, sides
 * and heights are those of the body's frame.
 */
public final class SkinMotion {
    private static final double WITH_BONE_MM = 45;
    private static final double FADE_MM = 90;
    /** The abdominal weight is 0 up to this distance from bone and rises to 1 over the next {@code FREE_OVER_MM}. */
    private static final double FREE_MM = 10;

    private static final double FREE_OVER_MM = 85;
    /**
     * Distance from the tip of the sternum to the pubis in an adult, chosen. {@code RISE} and {@code FALL} are the
     * shares of it over which the weight rises and falls.
     */
    private static final double WALL_MM = 320;

    private static final double RISE = 0.2;
    private static final double FALL = 0.35;
    private static final int PARTS = 100;
    /**
     * The flanks move less than the front: the weight is 1 where the normal points anteriorly and falls to 0 where its
     * posterior component reaches this value.
     */
    private static final double SIDE = 0.6;
    /** Skin farther lateral than the diaphragm by this distance belongs to the arms and has weight 0. */
    private static final double BESIDE_MM = 60;

    private final double[] rest;
    private final LinearBlendSkinning withBones;
    private final double[] boneShare;
    private final double[] abdominalDisplacement;
    private final int[] abdominal;
    private final double[] nodesAtRest;
    private final double[] position;
    private final double[] velocity;

    /** @param pose of the rib cage at the time that is asked for */
    public SkinMotion(Scene scene, Structure skin, SkinningWeights bones, RibCagePose pose) {
        TriangleMesh mesh = skin.mesh();
        rest = mesh.positions();
        SkinningWeights.Weights blend = bones.weightsAt(rest);
        withBones = new LinearBlendSkinning(pose, rest, blend, Workers.of(1));
        boneShare = new double[mesh.vertexCount()];
        Arrays.setAll(boneShare, i -> FallOff.at(Math.max(0, blend.distance()[i] - WITH_BONE_MM), FADE_MM));
        abdominal = scene.diaphragm().abdominalTriangles();
        nodesAtRest = scene.restPositions();
        MedianFrame frame = scene.diaphragm().diaphragm.frame();
        double top = top(scene);
        TriangleMesh upright = frame.toFrame(mesh);
        double[] weights = abdominalWeights(scene, upright, blend.distance(), top);
        double whole = sum(weights, mesh);
        double lowest = upright.bounds()[2];
        for (Structure other : scene.thorax().structuresOf(StructureKind.SKIN)) {
            if (!other.name().equals(skin.name())) {
                TriangleMesh piece = other.mesh();
                TriangleMesh uprightPiece = frame.toFrame(piece);
                whole += sum(abdominalWeights(scene, uprightPiece, bones.distances(piece.positions()), top), piece);
                lowest = Math.min(lowest, uprightPiece.bounds()[2]);
            }
        }
        whole /= weightAbove((top - lowest) / WALL_MM);
        abdominalDisplacement = MeshMeasure.vertexNormals(mesh);
        for (int c = 0; c < rest.length; c++) {
            abdominalDisplacement[c] = whole > 0 ? weights[c / 3] * abdominalDisplacement[c] / whole : 0;
        }
        position = new double[rest.length];
        velocity = new double[rest.length];
    }

    /** Height of the lower end of the sternum in the body's frame, mm. */
    private static double top(Scene scene) {
        MedianFrame frame = scene.diaphragm().diaphragm.frame();
        double[] box = scene.diaphragm().diaphragm.upright().bounds();
        return scene.thorax().structuresOf(StructureKind.STERNUM).stream()
                .mapToDouble(s -> frame.toFrame(s.mesh()).bounds()[2])
                .min()
                .orElse(0.5 * (box[2] + box[5]));
    }

    private static double sum(double[] weights, TriangleMesh mesh) {
        double[] areas = MeshMeasure.vertexAreas(mesh);
        double sum = 0;
        for (int i = 0; i < areas.length; i++) {
            sum += weights[i] * areas[i];
        }
        return sum;
    }

    /**
     * Weight of each vertex in the abdominal wall.
     *
     * @param mesh the skin in the body's frame
     * @param toBone distance of each vertex from bone, mm
     * @param top height of the lower end of the sternum, mm
     */
    private static double[] abdominalWeights(Scene scene, TriangleMesh mesh, double[] toBone, double top) {
        double[] box = scene.diaphragm().diaphragm.upright().bounds();
        double middle = 0.5 * (box[0] + box[3]);
        double half = 0.5 * (box[3] - box[0]);
        double[] normals = MeshMeasure.vertexNormals(mesh);
        double[] weights = new double[mesh.vertexCount()];
        for (int i = 0; i < weights.length; i++) {
            weights[i] = SmoothBlends.smoothstep((SIDE - normals[3 * i + 1]) / (1 + SIDE))
                    * SmoothBlends.smoothstep((toBone[i] - FREE_MM) / FREE_OVER_MM)
                    * wallWeight((top - mesh.z(i)) / WALL_MM)
                    * SmoothBlends.smoothstep((half + BESIDE_MM - Math.abs(mesh.x(i) - middle)) / BESIDE_MM);
        }
        return weights;
    }

    /** Weight at relative position {@code u} along the wall, from the sternum (0) to the pubis (1); 0 at both ends. */
    private static double wallWeight(double u) {
        return SmoothBlends.smoothstep(u / RISE) * SmoothBlends.smoothstep((1 - u) / FALL);
    }

    /** Share of the total weight that lies above a relative position along the wall. */
    private static double weightAbove(double end) {
        double above = 0;
        double all = 0;
        for (int i = 0; i < PARTS; i++) {
            double u = (i + 0.5) / PARTS;
            all += wallWeight(u);
            above += u < end ? wallWeight(u) : 0;
        }
        return Math.max(above / all, 1.0 / PARTS);
    }

    /** Current positions of the skin's vertices; valid until the next call. Allocates nothing. */
    public double[] at(double time, double[] now) {
        withBones.at(time, position, velocity);
        double volume = SweptVolume.of(abdominal, nodesAtRest, now);
        for (int i = 0; i < rest.length; i++) {
            position[i] = rest[i] + boneShare[i / 3] * (position[i] - rest[i]) + volume * abdominalDisplacement[i];
        }
        return position;
    }
}
