// The first page's picture: the scene that runs where no other is named, to be grabbed.
'use strict';

flyingLive('front', {
    view: [0, 0, 12, 8],
    checkTime: 3,
    tallest: 640,
    grab: true,
    scene: () => flyingScenes['balls-and-polygons'],
    draw: (stage, t, s, p, run) => {
        stage.walls([0, 0, 12, 8]);
        run.states().forEach((state, k) => stage.body(run.shapes[k], state, { colour: stage.colour(k), isFixed: run.isStatic(k) }));
    }
});
