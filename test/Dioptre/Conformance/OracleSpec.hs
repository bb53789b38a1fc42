{-# LANGUAGE OverloadedStrings #-}

-- | Every operation, on examples worked out by hand.
module Dioptre.Conformance.OracleSpec
  ( spec,
  )
where

import Control.Monad (forM_)
import Data.Aeson (Value (..), decode, encode, object, (.=))
import qualified Data.Aeson.Key as Key
import qualified Data.Aeson.KeyMap as Keys
import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Lazy as Lazy
import Data.Either (isLeft)
import Data.List (nub, sort)
import Data.Maybe (fromMaybe)
import Data.Text (Text)
import qualified Data.Text as Text
import qualified Data.Vector as Vector
import Dioptre.Conformance.Compare (Comparison (..))
import Dioptre.Conformance.Oracle
import Dioptre.Conformance.Protocol (Answer (..), Outcome (..), binary64, writeAnswer)
import Dioptre.Conformance.Verdict (Case (..), Verdict (..), judge)
import Test.Hspec (Spec, describe, it, shouldBe)
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck (Gen, arbitrary, choose, elements, forAll, listOf, oneof, resize, sized, vectorOf, (===))

spec :: Spec
spec = do
  describe "an operation" $ do
    forM_ (nub [operation | (operation, _, _, _) <- examples]) $ \operation ->
      it (Text.unpack operation) $
        [ (input, outcome)
          | (o, input, how, expected) <- examples,
            o == operation,
            let outcome = judge (Case "" "" o [] "" [] (json input) (json expected) how) . either Fault Ok <$> perform o (json input),
            outcome /= Just Passed
        ]
          `shouldBe` []
    it "has an example here" $ sort (nub [operation | (operation, _, _, _) <- examples]) `shouldBe` sort [operation | (_, operations) <- profiles, (operation, _) <- operations]
    it "answers an error where it is asked what makes no sense" $
      [(operation, input) | (operation, input) <- senseless, maybe True (not . isLeft) (perform operation (json input))] `shouldBe` []
    it "does without what has a default" $
      perform "transform.matrix" (json "{}") `shouldBe` Just (Right (json "[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]]"))
  describe "an answer" $ do
    it "introduces this program" $
      answer "1.2.3" "{\"id\":0,\"op\":\"start\"}"
        `shouldBe` Answer (Just 0) (Ok (object ["implementation" .= text "dioptre", "language" .= text "Haskell", "version" .= text "1.2.3", "profiles" .= map text ["maths", "geometry", "optics", "lighting", "scene", "picture"]]))
    it "skips an operation that is not there" $ answer "" "{\"id\":5,\"op\":\"vector.fold\",\"in\":{}}" `shouldBe` Answer (Just 5) (Skip "not implemented")
    it "has a result, or an error" $
      map (answer "") ["{\"id\":7,\"op\":\"roots.quadratic\",\"in\":{\"a\":1,\"b\":-3,\"c\":2},\"more\":0}", "{\"id\":8,\"op\":\"roots.quadratic\",\"in\":{\"a\":1,\"b\":-3}}"]
        `shouldBe` [Answer (Just 7) (Ok (json "[1,2]")), Answer (Just 8) (Fault "Error in $: key \"c\" not found")]
    modifyMaxSuccess (const 3000) . prop "is there for any arguments, and holds finite numbers only" . forAll anything $ \(operation, input) ->
      let a = answer "" (Lazy.toStrict ("{\"id\":1,\"op\":\"" <> Lazy.fromStrict operation <> "\",\"in\":" <> input <> "}"))
       in (answerId a, Lazy.length (writeAnswer a) > 0 && finite (answerOutcome a)) === (Just 1, True)
    modifyMaxSuccess (const 500) . prop "is there for any bytes" $ \bytes ->
      Lazy.length (writeAnswer (answer "" (Bytes.pack bytes))) > 0
  where
    text = String

finite :: Outcome -> Bool
finite outcome = case outcome of
  Ok value -> numbersIn value
  _ -> True
  where
    numbersIn v = case v of
      Number _ -> maybe False (not . isInfinite) (binary64 v)
      Array items -> all numbersIn items
      Object o -> all numbersIn (Keys.elems o)
      _ -> True

json :: Lazy.ByteString -> Value
json = fromMaybe (String "the test itself is not JSON") . decode

-- | An operation, its arguments, how to compare, and what comes out.
examples :: [(Text, Lazy.ByteString, Comparison, Lazy.ByteString)]
examples =
  [ ("vector.add", "{\"a\":[1,2,3],\"b\":[4,5,-6]}", Exact, "[5,7,-3]"),
    ("vector.subtract", "{\"a\":[1,2,3],\"b\":[4,5,-6]}", Exact, "[-3,-3,9]"),
    ("vector.dot", "{\"a\":[1,2,3],\"b\":[4,5,-6]}", Exact, "-4"),
    ("vector.cross", "{\"a\":[1,2,3],\"b\":[4,5,-6]}", Exact, "[-27,18,-3]"),
    ("vector.distance", "{\"a\":[1,1,1],\"b\":[3,4,7]}", Exact, "7"),
    ("vector.angle", "{\"a\":[1,0,0],\"b\":[1,1,0]}", Ulp 1, "0.7853981633974483"),
    ("vector.scale", "{\"a\":[1,2,3],\"k\":-2}", Exact, "[-2,-4,-6]"),
    ("vector.modulus", "{\"a\":[2,3,6]}", Exact, "7"),
    ("vector.normalize", "{\"a\":[0,3,4]}", Exact, "[0,0.6,0.8]"),
    ("vector.normalize", "{\"a\":[0,0,0]}", Exact, "null"),
    ("roots.linear", "{\"a\":2,\"b\":-3}", Exact, "[1.5]"),
    ("roots.quadratic", "{\"a\":1,\"b\":-4,\"c\":4}", Exact, "[2,2]"),
    -- (x - 1)(x - 2)(x - 3), and with x times.
    ("roots.cubic", "{\"a\":1,\"b\":-6,\"c\":11,\"d\":-6}", Exact, "[1,2,3]"),
    ("roots.quartic", "{\"a\":1,\"b\":-6,\"c\":11,\"d\":-6,\"e\":0}", Exact, "[0,1,2,3]"),
    -- A quarter turn about z takes x to y and y to -x; scale comes before, translation after.
    ("transform.matrix", "{\"scale\":[2,3,4],\"rotation\":[0,0,90],\"translation\":[5,6,7]}", Exact, "[[0,-3,0,5],[2,0,0,6],[0,0,4,7],[0,0,0,1]]"),
    ("transform.position", "{\"scale\":[2,3,4],\"rotation\":[0,0,90],\"translation\":[5,6,7],\"vector\":[1,1,1]}", Exact, "[2,8,11]"),
    ("transform.direction", "{\"scale\":[2,3,4],\"rotation\":[0,0,90],\"translation\":[5,6,7],\"vector\":[1,1,1]}", Exact, "[-3,2,4]"),
    -- The plane x + y = 0 becomes x/2 + y = 0.
    ("transform.normal", "{\"scale\":[2,1,1],\"vector\":[1,1,0]}", Ulp 2, "[0.4472135954999579,0.8944271909999159,0]"),
    ("transform.ray", "{\"scale\":[2,2,2],\"translation\":[0,0,1],\"ray\":{\"origin\":[1,0,0],\"direction\":[0,0,1]}}", Exact, "{\"origin\":[2,0,1],\"direction\":[0,0,2]}"),
    ("ray.position", "{\"ray\":{\"origin\":[1,2,3],\"direction\":[0,0,2]},\"t\":1.5}", Exact, "[1,2,6]"),
    ("intersect.plane", "{\"ray\":{\"origin\":[0,0,5],\"direction\":[0,0,-2]},\"position\":[0,0,1],\"normal\":[0,0,3]}", Exact, "[2]"),
    ("intersect.plane", "{\"ray\":{\"origin\":[0,0,1],\"direction\":[1,0,0]},\"position\":[0,0,1],\"normal\":[0,0,1]}", Exact, "[]"),
    ("intersect.sphere", "{\"ray\":{\"origin\":[0,0,5],\"direction\":[0,0,1]},\"position\":[0,0,0],\"radius\":2}", Exact, "[-7,-3]"),
    ("intersect.tube", "{\"ray\":{\"origin\":[-5,0,9],\"direction\":[1,0,0]},\"point\":[0,0,0],\"axis\":[0,0,2],\"radius\":2}", Exact, "[3,7]"),
    -- At height z the cones' radius is |1 - z|; at z = 2, beyond the apex, 1 again.
    ("intersect.cones", "{\"ray\":{\"origin\":[-5,0,2],\"direction\":[1,0,0]},\"point\":[0,0,0],\"apex\":[0,0,1],\"radius\":1}", Exact, "[4,6]"),
    ("intersect.torus", "{\"ray\":{\"origin\":[-10,0,0],\"direction\":[1,0,0]},\"position\":[0,0,0],\"normal\":[0,0,1],\"major_radius\":2,\"minor_radius\":1}", Exact, "[7,9,11,13]"),
    ("geometry.hit", "{\"geometry\":{\"kind\":\"sphere\",\"position\":[0,0,1],\"ray\":2},\"ray\":{\"origin\":[0,0,9],\"direction\":[0,0,-1]}}", Absolute 1e-15, "{\"t\":6,\"point\":[0,0,3],\"normal\":[0,0,1],\"uv\":[0.75,0.5]}"),
    ("geometry.hit", "{\"geometry\":{\"kind\":\"sphere\"},\"ray\":{\"origin\":[0,0,9],\"direction\":[0,0,1]}}", Exact, "null"),
    ("geometry.hit", "{\"geometry\":{\"kind\":\"geometry\",\"scale\":[1,1,2],\"geometry\":{\"kind\":\"btriangle\",\"point\":[[0,0,0],[4,0,0],[0,4,0]],\"uv\":[[0,0],[1,0],[0,2]]}},\"ray\":{\"origin\":[1,1,6],\"direction\":[0,0,-2]}}", Exact, "{\"t\":3,\"point\":[1,1,0],\"normal\":[0,0,1],\"uv\":[0.25,0.5]}"),
    -- The upper face is of a sphere around (0, 0, 2 - sqrt 3); at 0.5 from the axis it is at a height of sqrt 3.75
    -- above its centre.
    ("geometry.hit", "{\"geometry\":{\"kind\":\"lens\",\"point\":[[0,0,0],[0,0,2]],\"curvature\":[2,2]},\"ray\":{\"origin\":[0,0.5,9],\"direction\":[0,0,-1]}}", Absolute 1e-14, "{\"t\":6.795559134465169,\"point\":[0,0.5,2.2044408655348313],\"normal\":[0,0.25,0.9682458365518543],\"uv\":[0.5,0.25]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"cube\",\"size\":2},\"point\":[0.9,0.9,-0.9]}", Exact, "true"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"cube\",\"size\":2},\"point\":[1,0,0]}", Exact, "false"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"plane\"},\"point\":[0,0,-1]}", Exact, "false"),
    ("triangle.barycentric", "{\"points\":[[0,0,0],[4,0,0],[0,2,0]],\"point\":[1,1,5]}", Exact, "[0.25,0.5]"),
    ("optics.reflect", "{\"direction\":[3,0,-4],\"normal\":[0,0,2]}", Absolute 1e-15, "[0.6,0,0.8]"),
    -- sin a2 = 1.5 sin a1 with sin a1 = 0.6 is 0.9; and 1.5 * 0.8 is beyond 1.
    ("optics.refract", "{\"direction\":[0.6,0,-0.8],\"normal\":[0,0,1],\"n1\":1.5,\"n2\":1}", Absolute 1e-15, "[0.9,0,-0.4358898943540674]"),
    ("optics.refract", "{\"direction\":[0.8,0,-0.6],\"normal\":[0,0,1],\"n1\":1.5,\"n2\":1}", Exact, "null"),
    ("light.ambient", "{\"light\":[1,0.5,2],\"surface\":[0.5,0.5,0.25]}", Exact, "[0.5,0.25,0.5]"),
    ("light.lambert", "{\"light\":[1,1,1],\"surface\":[1,0.5,0],\"normal\":[0,0,1],\"direction\":[0.6,0,-0.8]}", Exact, "[0.8,0.4,0]"),
    ("light.lambert", "{\"light\":[1,1,1,0.5],\"surface\":[1,0.5,0],\"normal\":[0,0,1],\"direction\":[0.6,0,0.8]}", Exact, "[0,0,0]"),
    -- Half way between (0, 0.6, 0.8) and (0, -0.6, 0.8) is the normal.
    ("light.blinn", "{\"light\":[1,2,1],\"surface\":[1,0.5,0],\"normal\":[0,0,1],\"direction\":[0,-0.6,-0.8],\"view\":[0,0.6,-0.8],\"shininess\":20}", Relative 1e-14, "[1,1,0]"),
    -- The mirrored light goes straight into the viewer's eye, or misses it by a right angle.
    ("light.phong", "{\"light\":[1,2,1],\"surface\":[1,0.5,0],\"normal\":[0,0,1],\"direction\":[0,-0.6,-0.8],\"view\":[0,0.6,-0.8],\"shininess\":20}", Relative 1e-13, "[1,1,0]"),
    ("light.phong", "{\"light\":[1,2,1],\"surface\":[1,0.5,0],\"normal\":[0,0,1],\"direction\":[0,0,-1],\"view\":[0,1,0],\"shininess\":0}", Exact, "[1,1,0]"),
    ("scene.check", "{\"text\":\"viewport\\n  widht 3\\nend\\n\"}", Exact, "{\"diagnostics\":[{\"code\":\"unknown-word\",\"severity\":\"error\",\"line\":2,\"column\":3}]}"),
    -- The picture is 2 x 2 and the near plane 2 tan 30 degrees high; the camera looks along x, with y to the left.
    ("camera.ray", "{\"text\":\"camera\\nlook_at 1 0 0\\nup 0 0 1\\nend\\nviewport\\nwidth 2\\nheight 2\\nend\\n\",\"column\":1,\"row\":1,\"sample\":0}", Absolute 1e-15, "{\"origin\":[1,0,0],\"direction\":[1,0,0]}"),
    ("scene.pixel", "{\"text\":\"\",\"column\":3,\"row\":4}", Exact, "[0,0,0,255]"),
    -- Two black opaque pixels: 0 0 0 255 0 0 0 255.
    ("scene.picture", "{\"text\":\"viewport\\nwidth 2\\nheight 1\\nend\\n\"}", Exact, "{\"width\":2,\"height\":1,\"rgba\":\"AAAA/wAAAP8=\"}")
  ]

-- | Arguments that have no result.
senseless :: [(Text, Lazy.ByteString)]
senseless =
  [ ("vector.add", "{\"a\":[1,2,3]}"),
    ("vector.add", "{\"a\":[1,2,3],\"b\":[1,2]}"),
    ("vector.add", "{\"a\":[1,2,3],\"b\":[1,2,\"3\"]}"),
    ("vector.add", "{\"a\":[1e308,0,0],\"b\":[1e308,0,0]}"),
    ("vector.add", "{\"a\":[1e309,0,0],\"b\":[0,0,0]}"),
    ("vector.add", "[]"),
    ("roots.linear", "{\"a\":1,\"b\":null}"),
    ("transform.matrix", "{\"scale\":[1,0,1]}"),
    ("transform.normal", "{\"vector\":[0,0,0]}"),
    ("ray.position", "{\"ray\":{\"origin\":[0,0,0],\"direction\":[0,0,0]},\"t\":1}"),
    ("intersect.plane", "{\"ray\":{\"origin\":[0,0,0],\"direction\":[0,0,1]},\"position\":[0,0,0],\"normal\":[0,0,0]}"),
    ("intersect.tube", "{\"ray\":{\"origin\":[0,0,0],\"direction\":[0,0,1]},\"point\":[0,0,0],\"axis\":[0,0,0],\"radius\":1}"),
    ("intersect.torus", "{\"ray\":{\"origin\":[0,0,0],\"direction\":[0,0,1]},\"position\":[0,0,0],\"normal\":[0,0,1],\"major_radius\":0,\"minor_radius\":1}"),
    ("geometry.contains", "{\"geometry\":{},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphre\"},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"camera\"},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"radius\":1},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"ray\":0},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"ray\":\"1\"},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"ray\":[]},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"position\":1},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"position\":[1,2]},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"sphere\",\"position\":[1e200,0,0]},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"geometry\"},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"geometry\",\"geometry\":{\"kind\":\"sphere\",\"ray\":-1}},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"triangle\",\"point\":[[0,0,0],[1,1,1],[2,2,2]]},\"point\":[0,0,0]}"),
    ("geometry.contains", "{\"geometry\":{\"kind\":\"triangle\",\"point\":[[0,0,0],[1,1,1],[2,2,3],[4,5,6]]},\"point\":[0,0,0]}"),
    ("triangle.barycentric", "{\"points\":[[0,0,0],[1,1,1],[2,2,2]],\"point\":[0,0,0]}"),
    ("triangle.barycentric", "{\"points\":[[0,0,0],[1,1,1]],\"point\":[0,0,0]}"),
    ("optics.reflect", "{\"direction\":[0,0,0],\"normal\":[0,0,1]}"),
    ("optics.refract", "{\"direction\":[0,0,1],\"normal\":[0,0,1],\"n1\":0,\"n2\":1}"),
    ("light.ambient", "{\"light\":[-1,0,0],\"surface\":[1,1,1]}"),
    ("light.ambient", "{\"light\":[1,0],\"surface\":[1,1,1]}"),
    ("light.phong", "{\"light\":[1,1,1],\"surface\":[1,1,1],\"normal\":[0,0,1],\"direction\":[0,0,-1],\"view\":[0,0,-1],\"shininess\":-1}"),
    ("scene.check", "{\"text\":1}"),
    ("scene.pixel", "{\"text\":\"\",\"column\":500,\"row\":0}"),
    ("scene.pixel", "{\"text\":\"\",\"column\":-1,\"row\":0}"),
    ("scene.pixel", "{\"text\":\"\",\"column\":0.5,\"row\":0}"),
    ("camera.ray", "{\"text\":\"\",\"column\":0,\"row\":0,\"sample\":1}")
  ]

-- | Any operation but the drawing of whole pictures, with arguments under its own names that may make sense.
anything :: Gen (Bytes.ByteString, Lazy.ByteString)
anything = (,) <$> elements ["vector.angle", "vector.normalize", "roots.quadratic", "roots.quartic", "transform.matrix", "transform.ray", "intersect.plane", "intersect.sphere", "intersect.tube", "intersect.cones", "intersect.torus", "geometry.hit", "geometry.contains", "triangle.barycentric", "optics.reflect", "optics.refract", "light.lambert", "light.blinn", "light.phong", "scene.check", "camera.ray"] <*> object'
  where
    object' = do
      known <- traverse member ["a", "b", "c", "d", "e", "t", "k", "radius", "major_radius", "minor_radius", "n1", "n2", "shininess", "column", "row"]
      vectors <- traverse (\name -> (,) name <$> vector) ["vector", "scale", "rotation", "translation", "position", "normal", "point", "axis", "apex", "direction", "view", "light", "surface"]
      from <- vector
      towards <- vector
      shape <- oneof [shapeOf, value]
      text <- elements ["", "camera\nangle 20\nend\n", "primitive\nsphere\nray"]
      more <- oneof [pure [], pure <$> ((,) <$> elements ["a", "ray", "geometry", "text", "light"] <*> value)]
      pure (encode (Object (Keys.fromList ([("ray", object ["origin" .= from, "direction" .= towards]), ("geometry", shape), ("text", String text)] <> known <> vectors <> more))))
    member name = (,) name <$> oneof [number, vector]
    vector = Array . Vector.fromList <$> vectorOf 3 number
    number = Number <$> oneof [realToFrac <$> (arbitrary :: Gen Double), fromIntegral <$> choose (-2, 2 :: Int), pure 1e300, pure 1e-300]
    shapeOf = do
      kind <- elements ["sphere", "plane", "disk", "annulus", "triangle", "btriangle", "tube", "cylinder", "cone", "cube", "spherical_cap", "lens", "torus", "geometry"]
      members <- listOf ((,) . Key.fromText <$> elements ["position", "normal", "ray", "point", "curvature", "size", "uv", "scale", "major_radius"] <*> oneof [number, vector, Array . Vector.fromList <$> resize 3 (listOf vector)])
      pure (Object (Keys.fromList ([("kind", String kind)] <> members <> [("geometry", object ["kind" .= ("cube" :: Text)]) | kind == "geometry"])))
    value = resize 8 . sized $ \n -> oneof ([pure Null, Bool <$> arbitrary, number, String <$> elements ["", "sphere"]] <> [Array . Vector.fromList <$> resize (n `div` 2) (listOf value) | n > 0])
