package org.phrenic.simulation.observe;

import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.cage.LinearBlendSkinning;
import org.phrenic.anatomy.cage.SkinningWeights;
import org.phrenic.engine.force.FallOff;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.model.assembly.Scene;

/**
 * How the skin moves: for display only, nothing is driven or measured by it.
 *
 * <p>Over the cage it goes with the bones below it ({@link LinearBlendSkinning}), wholly where it is near to them and
 * not at all far from them: {@code x = X + f(d) (x_bones(X) - X)}, {@code d} the distance from bone, {@code f} 1 up to
 * {@value #WITH_BONE_MM} mm and the fall-off to 0 over {@value #FADE_MM} mm more. The belly comes forward by the volume
 * that the diaphragm takes from the abdomen, whose contents are incompressible (De Troyer and Boriek 2011, doi
 * 10.1002/cphy.c100009): {@code V} is what its abdominal face sweeps, the widening of the apposed rib cage subtracted
 * by its own motion, and each point of the anterior and lateral wall between costal margin and pubis moves out along
 * its normal by {@code V w / Σ w A}, {@code w} a smooth weight and {@code A} the area of a vertex; a skin that ends
 * higher up takes the share of the wall that it has.
 */
public final class SkinMotion {
    private static final double WITH_BONE_MM = 45;
    private static final double FADE_MM = 90;
    /** The belly comes forward where bone is farther than this, and wholly where it is farther by the other. */
    private static final double FREE_MM = 10;

    private static final double FREE_OVER_MM = 85;
    /**
     * From the tip of the sternum to the pubis in an adult, chosen; and the shares of it over which the weight rises
     * and falls.
     */
    private static final double WALL_MM = 320;

    private static final double RISE = 0.2;
    private static final double FALL = 0.35;
    private static final int PARTS = 100;
    /**
     * The flanks give way too, less than the front: the weight is 1 where the skin looks forward and 0 where its normal
     * points so far back.
     */
    private static final double SIDE = 0.6;
    /** What is farther out than the diaphragm by this is arm. */
    private static final double BESIDE_MM = 60;

    private final double[] rest;
    private final LinearBlendSkinning withBones;
    private final double[] boneShare;
    private final double[] abdominalDisplacement;
    private final int[] abdominal;
    private final double[] nodesAtRest;
    private final double[] position;
    private final double[] velocity;

    public SkinMotion(Scene scene, Structure skin, SkinningWeights bones) {
        TriangleMesh mesh = skin.mesh();
        rest = mesh.positions();
        SkinningWeights.Weights blend = bones.weightsAt(rest);
        withBones = new LinearBlendSkinning(
                scene.pose(), rest, blend, scene.system().workers());
        boneShare = new double[mesh.vertexCount()];
        for (int i = 0; i < boneShare.length; i++) {
            boneShare[i] = FallOff.at(Math.max(0, blend.distance()[i] - WITH_BONE_MM), FADE_MM);
        }
        abdominal = scene.diaphragm().abdominalTriangles();
        nodesAtRest = scene.restPositions();
        abdominalDisplacement = abdominalDisplacement(scene, mesh, blend.distance());
        position = new double[rest.length];
        velocity = new double[rest.length];
    }

    /** Displacement of each vertex for a volume of 1 mm³, mm. */
    private static double[] abdominalDisplacement(Scene scene, TriangleMesh mesh, double[] toBone) {
        double[] box = scene.diaphragm().diaphragm.sheet().bounds();
        double middle = 0.5 * (box[0] + box[3]);
        double half = 0.5 * (box[3] - box[0]);
        double top = scene.thorax().structuresOf(StructureKind.STERNUM).stream()
                .mapToDouble(s -> s.mesh().bounds()[2])
                .min()
                .orElse(0.5 * (box[2] + box[5]));
        double[] normals = MeshMeasure.vertexNormals(mesh);
        double[] areas = MeshMeasure.vertexAreas(mesh);
        double[] out = new double[3 * areas.length];
        double sum = 0;
        for (int i = 0; i < areas.length; i++) {
            double w = smooth((SIDE - normals[3 * i + 1]) / (1 + SIDE))
                    * smooth((toBone[i] - FREE_MM) / FREE_OVER_MM)
                    * wallWeight((top - mesh.z(i)) / WALL_MM)
                    * smooth((half + BESIDE_MM - Math.abs(mesh.x(i) - middle)) / BESIDE_MM);
            sum += w * areas[i];
            for (int c = 3 * i; c < 3 * i + 3; c++) {
                out[c] = w * normals[c];
            }
        }
        double whole = sum / weightAbove((top - mesh.bounds()[2]) / WALL_MM);
        for (int c = 0; c < out.length; c++) {
            out[c] = whole > 0 ? out[c] / whole : 0;
        }
        return out;
    }

    /** Weight along the wall, 0 at the sternum (0) and the pubis (1). */
    private static double wallWeight(double u) {
        return smooth(u / RISE) * smooth((1 - u) / FALL);
    }

    /** Share of the wall, by weight, that lies above a place along it. */
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

    private static double smooth(double u) {
        double s = Math.max(0, Math.min(1, u));
        return s * s * (3 - 2 * s);
    }

    /** Where the skin's vertices are; valid until the next call. Allocates nothing. */
    public double[] at(double time, double[] now) {
        withBones.at(time, position, velocity);
        double volume = SweptVolume.of(abdominal, nodesAtRest, now);
        for (int i = 0; i < rest.length; i++) {
            position[i] = rest[i] + boneShare[i / 3] * (position[i] - rest[i]) + volume * abdominalDisplacement[i];
        }
        return position;
    }
}
