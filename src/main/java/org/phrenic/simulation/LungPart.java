package org.phrenic.simulation;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Structure;
import org.phrenic.engine.force.FallOff;
import org.phrenic.geometry.TriangleMesh;

/**
 * The lungs as part of a scene: springs along their surface; at the base springs to the thoracic face of the diaphragm, elsewhere attachments of low elasticity to the chest wall, which fade toward the base so
 * that the lung can follow the dome down.
 */
final class LungPart {
    /** A lung's vertex nearer than this to the diaphragm belongs to the base. */
    private static final double BASE_MM = 9;

    /** Over this distance from the base the attachment to the chest wall comes to its full strength. */
    private static final double FADE_MM = 80;

    /** A spring needs a length. */
    private static final double SHORTEST_MM = 0.2;

    private static final double WALL = 0.6;
    private static final double LINK = 4;

    final List<Structure> structures;
    final List<Integer> firsts = new ArrayList<>();

    /**
     * @param stiffness of the lungs as a multiple of relaxed muscle's
     */
    LungPart(SceneParts parts, List<Structure> lungs, DiaphragmPart diaphragm, TissueLaw law, double stiffness) {
        structures = lungs;
        NearestVertex thoracic = thoracicFace(diaphragm.diaphragm);
        double edge = law.edgeStiffness(2, stiffness);
        for (Structure s : lungs) {
            TriangleMesh mesh = s.mesh();
            int first = parts.addNodes(mesh, law.masses(mesh, stiffness));
            firsts.add(first);
            law.addEdges(parts.passive, mesh, first, stiffness);
            for (int i = 0; i < mesh.vertexCount(); i++) {
                int near = thoracic.find(mesh.x(i), mesh.y(i), mesh.z(i));
                double distance = thoracic.distance();
                if (distance < BASE_MM && distance > SHORTEST_MM) {
                    parts.passive.add(first + i, diaphragm.first + near, LINK * edge, distance, 0);
                } else {
                    parts.attach(first + i, WALL * edge * (1 - FallOff.at(distance - BASE_MM, FADE_MM)));
                }
            }
        }
    }

    /** Finds vertices of the diaphragm's thoracic face. */
    static NearestVertex thoracicFace(Diaphragm diaphragm) {
        return new NearestVertex(diaphragm.sheet(), diaphragm::isThoracic);
    }
}
