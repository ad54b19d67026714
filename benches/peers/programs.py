"""The paper's mechanism by programs that take mechanisms as they are: exudyn and `mechanism`."""

import math

import numpy as np

import paper
from clock import nanoseconds

STEP = math.radians(0.27)


def by_exudyn(count):
    """Rigid bodies and joints, moved through `count` positions; the crank's angular velocity is given, so the motion is the kinematic one."""
    import exudyn as exu
    import exudyn.itemInterface as item

    container = exu.SystemContainer()
    system = container.AddSystem()
    ground = system.AddObject(item.ObjectGround())
    phi = math.radians(70.0)
    t2, s, t4, t5 = paper.start_at(phi)

    def place(angle, length, x=0.0, y=0.0):
        return np.array([x + length * math.cos(angle), y + length * math.sin(angle)])

    b = place(phi, paper.AB)
    d = place(t2, s, *b)
    e = place(t2, paper.BE, *b)
    g = np.array([paper.GX, paper.GY])
    f = place(t4 + paper.GAMMA, paper.GF, *g)
    rates, _ = paper.true_rates()

    def body(at, angle, velocity, omega):
        """A rigid body with its node in a joint."""
        node = system.AddNode(
            item.NodeRigidBody2D(
                referenceCoordinates=[*at, angle], initialVelocities=[*velocity, omega]
            )
        )
        return system.AddObject(
            item.ObjectRigidBody2D(physicsMass=1, physicsInertia=1e4, nodeNumber=node)
        ), node

    def turned(vector, omega):
        return np.array([-omega * vector[1], omega * vector[0]])

    w2, _, w4, w5 = rates
    vb = turned(b, paper.OMEGA)
    vf = turned(f - g, w4)
    vd = turned(d - g, w4)
    one, crank = body([0.0, 0.0], phi, [0.0, 0.0], paper.OMEGA)
    two, _ = body(b, t2, vb, w2)
    three, _ = body(d, t2, vd, w2)
    four, node = body(g, t4, [0.0, 0.0], w4)
    five, _ = body(f, t5, vf, w5)

    def marker(body, x, y=0.0):
        return system.AddMarker(item.MarkerBodyRigid(bodyNumber=body, localPosition=[x, y, 0]))

    def pin(first, second):
        system.AddObject(item.ObjectJointRevolute2D(markerNumbers=[marker(*first), marker(*second)]))

    pin((ground, 0.0), (one, 0.0))
    pin((one, paper.AB), (two, 0.0))
    pin((ground, *g), (four, 0.0))
    pin((three, 0.0), (four, paper.GD))
    pin((four, paper.GF * math.cos(paper.GAMMA), paper.GF * math.sin(paper.GAMMA)), (five, 0.0))
    pin((two, paper.BE), (five, paper.FE))
    system.AddObject(
        item.ObjectJointPrismatic2D(
            markerNumbers=[marker(two, 0.0), marker(three, 0.0)],
            axisMarker0=[1, 0, 0],
            normalMarker1=[0, 1, 0],
            constrainRotation=True,
        )
    )
    turns = system.AddMarker(item.MarkerNodeCoordinate(nodeNumber=crank, coordinate=2))
    fixed = system.AddMarker(
        item.MarkerNodeCoordinate(nodeNumber=system.AddNode(item.NodePointGround()), coordinate=0)
    )
    system.AddObject(
        item.ObjectConnectorCoordinate(markerNumbers=[fixed, turns], offset=paper.OMEGA, velocityLevel=True)
    )
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = count
    settings.timeIntegration.endTime = STEP * count
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e9
    settings.displayStatistics = settings.displayComputationTime = False

    def work():
        system.SolveDynamic(settings)
        output = system.GetNodeOutput
        return [output(node, kind)[2] for kind in (exu.OutputVariableType.Coordinates_t, exu.OutputVariableType.Coordinates_tt)]

    return work


def by_mechanism(angles):
    """A `Mechanism` of vectors, with a third loop for the triangle of link 4."""
    from mechanism import Mechanism, Vector, get_joints

    joints = get_joints("A B D E F G")
    a, b, d, e, f, g = joints
    ab = Vector((a, b), r=paper.AB)
    bd = Vector((b, d))
    be = Vector((b, e), r=paper.BE)
    gd = Vector((g, d), r=paper.GD)
    gf = Vector((g, f), r=paper.GF)
    df = Vector((d, f), r=paper.DF)
    fe = Vector((f, e), r=paper.FE)
    ag = Vector((a, g), r=paper.GX, theta=0)

    def loops(x, i):
        gaps = np.zeros((3, 2))
        gaps[0] = ab(i) + bd(x[1], x[0]) - gd(x[2]) - ag()
        gaps[1] = ab(i) + be(x[0]) - fe(x[3]) - gf(x[4]) - ag()
        gaps[2] = gd(x[2]) + df(x[5]) - gf(x[4])
        return gaps.flatten()

    t2, s, t4, t5 = paper.start_at(angles[0])
    t6 = t4 + paper.GAMMA
    edge = paper.GF * np.array([math.cos(t6), math.sin(t6)]) - paper.GD * np.array([math.cos(t4), math.sin(t4)])
    guess = np.array([t2, s, t4, t5, t6, math.atan2(edge[1], edge[0])])
    ones = np.ones(angles.size)
    whole = Mechanism(
        vectors=(ab, bd, be, gd, gf, df, fe, ag),
        origin=a,
        loops=loops,
        pos=angles,
        vel=paper.OMEGA * ones,
        acc=0 * ones,
        guess=(guess, np.zeros(6), np.zeros(6)),
    )

    def work():
        whole.iterate()
        return gd.vel.omegas[-1], gd.acc.alphas[-1]

    return work


def check(who, found, degrees, within):
    """Its ω and α of link 4 at that crank angle, against the loop equations."""
    velocities, accelerations = paper.true_rates(degrees)
    for got, want in zip(found, (velocities[2], accelerations[2])):
        assert abs(got / want - 1) < within, f"{who}: {got} for {want}"


def measure():
    """Rows of the table: job, who, nanoseconds."""
    count = 500
    work = by_exudyn(count)
    check("exudyn", work(), 70.0 - math.degrees(STEP * count), 1e-2)
    yield "paper", "exudyn: kinematic motion", nanoseconds(work, count, 5)
    angles = np.radians(np.linspace(70.0, 60.0, 20))
    work = by_mechanism(angles)
    check("mechanism", work(), 60.0, 1e-6)
    yield "paper", "mechanism (PyPI)", nanoseconds(work, angles.size, 3)
