"""Two spheres of 5 mm meet in Kratos' DEM application; prints the coefficient of restitution.

Arguments: the material as JSON, the relation as JSON, radius, density, speed, time step, end time. Works in the current folder.
"""

import json
import sys

import KratosMultiphysics as Kratos
from KratosMultiphysics.DEMApplication.DEM_analysis_stage import DEMAnalysisStage

EMPTY = "Begin ModelPartData\nEnd ModelPartData\n\nBegin Properties 0\nEnd Properties\n\n"
SPHERES = EMPTY + """Begin Nodes
1 0.0 0.0 -{place}
2 0.0 0.0 {place}
End Nodes

Begin Elements SphericParticle3D
1 0 1
2 0 2
End Elements

Begin NodalData RADIUS
1 0 {radius}
2 0 {radius}
End NodalData
"""
PART = """
Begin SubModelPart {name}
Begin SubModelPartData
INITIAL_VELOCITY_Z_VALUE {velocity}
End SubModelPartData
Begin SubModelPartNodes
{number}
End SubModelPartNodes
Begin SubModelPartElements
{number}
End SubModelPartElements
End SubModelPart
"""


def main(material, relation, radius, density, speed, step, end):
    radius, speed = float(radius), float(speed)
    spheres = SPHERES.format(place=1.001 * radius, radius=radius)
    spheres += PART.format(name="A", velocity=speed / 2, number=1) + PART.format(name="B", velocity=-speed / 2, number=2)
    for name, text in (("", spheres), ("_FEM_boundary", EMPTY), ("_Clusters", EMPTY), ("_Inlet", EMPTY)):
        with open(f"pairDEM{name}.mdpa", "w") as file:
            file.write(text)
    friction = ("STATIC_FRICTION", "DYNAMIC_FRICTION", "ROLLING_FRICTION", "ROLLING_FRICTION_WITH_WALLS")
    materials = {
        "materials": [{"material_name": "M", "material_id": 1, "Variables": {"PARTICLE_DENSITY": float(density), **json.loads(material)}}],
        "material_relations": [{
            "material_names_list": ["M", "M"], "material_ids_list": [1, 1],
            "Variables": {**json.loads(relation), **dict.fromkeys(friction, 0.0), "FRICTION_DECAY": 500.0},
        }],
        "material_assignation_table": [["SpheresPart", "M"]],
    }
    with open("MaterialsDEM.json", "w") as file:
        json.dump(materials, file)
    settings = {
        "Dimension": 3, "PeriodicDomainOption": False, "BoundingBoxOption": False, "CleanIndentationsOption": False,
        "solver_settings": {"RemoveBallsInitiallyTouchingWalls": False, "strategy": "sphere_strategy",
                            "material_import_settings": {"materials_filename": "MaterialsDEM.json"}},
        "VirtualMassCoefficient": 1.0, "RotationOption": False, "DontSearchUntilFailure": False, "ElementType": "SphericPartDEMElement3D",
        "TranslationalIntegrationScheme": "Velocity_Verlet", "RotationalIntegrationScheme": "Direct_Integration",
        "GravityX": 0.0, "GravityY": 0.0, "GravityZ": 0.0, "MaxTimeStep": float(step), "FinalTime": float(end),
        "NeighbourSearchFrequency": 1, "OutputTimeStep": 1.0, "problem_name": "pair", "GraphExportFreq": 1.0, "VelTrapGraphExportFreq": 1.0,
    }

    class Pair(DEMAnalysisStage):
        def Finalize(self):
            one, two = (node.GetSolutionStepValue(Kratos.VELOCITY_Z) for node in self.spheres_model_part.Nodes)
            print("RESULT", (two - one) / speed, flush=True)
            super().Finalize()

    Pair(Kratos.Model(), Kratos.Parameters(json.dumps(settings))).Run()


main(*sys.argv[1:])
