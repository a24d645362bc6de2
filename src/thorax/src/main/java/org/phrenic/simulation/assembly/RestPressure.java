package org.phrenic.simulation.assembly;

import java.util.Arrays;
import org.phrenic.engine.ParticleSystem;
import org.phrenic.engine.constraint.ContactSurface;
import org.phrenic.engine.force.ConstantLoad;
import org.phrenic.engine.force.FacePressure;
import org.phrenic.engine.parallel.NodeLayout;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.parameter.Parameter;
import org.phrenic.parameter.TissueMaterial;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.organ.DiaphragmPart;
import org.phrenic.simulation.organ.SpringList;

/**
 * Pressure on the abdominal face at rest, and what holds the sheet in its given shape against it: tensions of its
 * springs ({@link Prestress}) and a dead load for what they leave. All three are in proportion to each other, so that
 * the shape stays whatever the pressure at rest is turned to.
 */
final class RestPressure {
    /** Conjugate-gradient iterations: beyond, tensions grow and the residual hardly falls. */
    private static final int ITERATIONS = 40;
    /** Nodes nearer than this to the wall lean on it at rest. */
    private static final double WALL_CONTACT_MM = 1;

    private static final double MIN_REST_SHARE = 0.3;
    private static final double DOME_RADIUS_MM = 70;

    private final double nominal;
    private final double shareAtAssembly;
    private final double[] tension;
    private final ConstantLoad load;
    private final double residual;

    /**
     * Puts the pressure into a scene and gives the sheet's springs the rest lengths that go with it.
     *
     * @param wall that the sheet leans on; null where it leans on nothing
     * @param sliding vertices of the sheet that may lean on it
     * @param slidingRest where they are at rest
     */
    RestPressure(
            Scenario scenario,
            ParticleSystem system,
            BreathDrive drive,
            DiaphragmPart diaphragm,
            SpringList springs,
            ContactSurface wall,
            int[] sliding,
            double[] slidingRest,
            double[] positions) {
        NodeLayout layout = system.layout();
        int[] pressed = diaphragm.abdominalTriangles();
        double[] weight = new double[pressed.length / 3];
        Arrays.fill(weight, 1);
        FacePressure pressure = new FacePressure(layout, pressed, weight, diaphragm.abdominalLeftShares());
        system.add(pressure);
        drive.attach(pressure);
        double atRest = Knob.REST_PRESSURE.valueIn(scenario);
        // Where none acts at first, tensions are at hand for when it is turned on.
        nominal = atRest > 0 ? atRest : Parameter.REST_PRESSURE.defaultFor(TissueMaterial.PHYSICAL);
        shareAtAssembly = atRest / nominal;
        int n = layout.nodeCount();
        double[] internal = new double[3 * n];
        pressure.setPressure(nominal);
        for (int block = 0; block < layout.blockCount(); block++) {
            pressure.addForces(system.positions(), system.velocities(), internal, block);
        }
        double[] pressing = new double[3 * n];
        layout.toCaller(internal, pressing);

        boolean[] free = new boolean[n];
        int vertices = diaphragm.diaphragm.sheet().vertexCount();
        for (int i = 0; i < vertices; i++) {
            free[diaphragm.firstNode + i] = !diaphragm.diaphragm.isInserted(i);
        }
        double[] normals = new double[3 * n];
        if (wall != null) {
            markLeaningNodes(wall, sliding, slidingRest, diaphragm, normals);
        }
        Prestress solver = new Prestress(positions, springs.nodeA(), springs.nodeB(), free, normals);
        tension = new double[springs.count()];
        double spacing = Math.sqrt(MeshMeasure.area(diaphragm.diaphragm.sheet()) / vertices);
        // Laplace's law for a dome shared by two faces, times the width of tissue that an edge stands for.
        Arrays.fill(tension, nominal * DOME_RADIUS_MM / 2 / 2 * spacing);
        solver.solve(pressing, tension, ITERATIONS);
        double[] stiffness = springs.stiffness();
        double[] length = springs.rest();
        for (int e = 0; e < tension.length; e++) {
            double rest = limitedRestLength(length[e], length[e] - tension[e] / stiffness[e]);
            tension[e] = stiffness[e] * (length[e] - rest);
            springs.setRest(e, shareAtAssembly == 1 ? rest : length[e] - shareAtAssembly * tension[e] / stiffness[e]);
        }
        double[] left = solver.unbalancedForce(pressing, tension);
        double squares = 0;
        double all = 0;
        for (int i = 0; i < left.length; i++) {
            squares += left[i] * left[i];
            all += free[i / 3] ? pressing[i] * pressing[i] : 0;
            left[i] = -left[i];
        }
        load = new ConstantLoad(layout, left);
        load.setLoadFactor(shareAtAssembly);
        system.add(load);
        residual = shareAtAssembly > 0 && all > 0 ? Math.sqrt(squares / all) : 0;
    }

    /** A rest length that muscle can be shortened from, mm. */
    static double limitedRestLength(double length, double rest) {
        return Math.max(MIN_REST_SHARE * length, rest);
    }

    private static void markLeaningNodes(
            ContactSurface wall, int[] sliding, double[] rest, DiaphragmPart diaphragm, double[] normals) {
        double[] plane = new double[5];
        wall.prepare(0);
        for (int i = 0; i < sliding.length; i++) {
            double x = rest[3 * i];
            double y = rest[3 * i + 1];
            double z = rest[3 * i + 2];
            wall.tangentPlane(i, x, y, z, plane, 0);
            if (diaphragm.diaphragm.isThoracic(sliding[i])
                    && plane[0] * x + plane[1] * y + plane[2] * z - plane[3] < WALL_CONTACT_MM) {
                System.arraycopy(plane, 0, normals, 3 * (diaphragm.firstNode + sliding[i]), 3);
            }
        }
    }

    /** Share of the load at rest that the dead load carries. */
    double residual() {
        return residual;
    }

    /** Tension of each spring of the sheet beyond that at the beginning when the pressure at rest is another, mN. */
    double additionalTension(int spring, double pressure) {
        return (pressure / nominal - shareAtAssembly) * tension[spring];
    }

    /** Scales the dead load with the pressure at rest, kPa. */
    void scaleLoad(double pressure) {
        load.setLoadFactor(pressure / nominal);
    }
}
