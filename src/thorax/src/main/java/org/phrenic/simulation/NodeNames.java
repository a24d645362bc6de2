package org.phrenic.simulation;

import java.util.List;
import org.phrenic.anatomy.Structure;
import org.phrenic.file.Numbers;
import org.phrenic.model.assembly.Scene;

/** Names the nodes of a scene by their structure and place at rest, for messages. */
final class NodeNames {
    private NodeNames() {}

    /**
     * Name of a node: {@code node 113 of the diaphragm (x -68, y -16, z 115 mm at rest)}.
     *
     * @param node number in the caller's order
     */
    static String of(Scene scene, int node) {
        double[] p = scene.restPositions();
        return Numbers.format(
                "node %d of %s (x %.0f, y %.0f, z %.0f mm at rest)",
                node, structure(scene, node), p[3 * node], p[3 * node + 1], p[3 * node + 2]);
    }

    private static String structure(Scene scene, int node) {
        int first = scene.diaphragm().firstNode;
        if (node >= first && node < first + scene.diaphragm().diaphragm.sheet().vertexCount()) {
            return "the diaphragm";
        }
        return scene.lungs()
                .map(part -> name(part.structures, part.firstNodes, node))
                .filter(name -> !name.isEmpty())
                .or(() -> scene.sternum().map(part -> name(part.structures, part.firstNodes, node)))
                .filter(name -> !name.isEmpty())
                .orElse("the scene");
    }

    private static String name(List<Structure> structures, List<Integer> firsts, int node) {
        for (int i = 0; i < structures.size(); i++) {
            int first = firsts.get(i);
            if (node >= first && node < first + structures.get(i).mesh().vertexCount()) {
                return structures.get(i).name();
            }
        }
        return "";
    }
}
