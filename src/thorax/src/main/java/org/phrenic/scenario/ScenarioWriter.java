package org.phrenic.scenario;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import org.phrenic.parameter.Parameter;

/** A scenario as keys and values, which {@link ScenarioReader} reads back. */
final class ScenarioWriter {
    private ScenarioWriter() {}

    /** Every key with its value, in the order of the documentation; keys whose value the preset gives are left out. */
    static Map<String, Object> map(Scenario s) {
        Map<String, Object> map = new LinkedHashMap<>();
        map.put("name", s.name());
        map.put("preset", s.preset());
        s.trace()
                .ifPresent(file ->
                        map.put("trace", file.toAbsolutePath().normalize().toString()));
        map.put("material", s.material().label());
        map.put(
                "anatomy",
                s.isVirtual()
                        ? s.anatomy()
                        : Path.of(s.anatomy()).toAbsolutePath().normalize().toString());
        map.put("resolution", ScenarioReader.label(s.resolution()));
        if (!Double.isNaN(s.givenDurationS())) {
            map.put("duration_s", s.givenDurationS());
        }
        if (s.givenSteps() >= 0) {
            map.put("steps", s.givenSteps());
        }
        map.put("time_step_s", s.timeStepS());
        map.put("integrator", s.integrator().label());
        map.put("step_policy", ScenarioReader.label(s.stepPolicy()));
        map.put("projection_sweeps", s.projectionSweeps());
        map.put("refresh_s", s.refreshS());
        map.put("mass_scaling_s", s.massScalingS());
        map.put("threads", s.threads());
        map.put("record_every_s", s.recordEveryS());
        map.put("meshes_every_s", s.meshesEveryS());
        map.put("muscle", s.muscle());
        map.put("pressure", s.pressure());
        map.put("ribs", s.ribs());
        map.put("tensegrity", s.tensegrity());
        map.put("contact", s.contact());
        map.put("sternum", s.sternum().label());
        map.put("lungs", s.lungs().label());
        map.put("liver", s.liver());
        map.put("links_per_node", s.linksPerNode());
        map.put("tendon", s.tendon().label());
        map.put("hold", s.hold());
        for (Parameter parameter : Parameter.values()) {
            if (!Double.isNaN(s.value(parameter))) {
                map.put(parameter.key(), s.value(parameter));
            }
        }
        if (!s.changes().isEmpty()) {
            map.put("changes", s.changes().stream().map(ScheduledChange::text).toList());
        }
        return map;
    }
}
